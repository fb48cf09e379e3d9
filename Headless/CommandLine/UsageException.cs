namespace Headless.CommandLine;

/// <summary>What was typed cannot be done. The message is one line: the flag, the value found, what is allowed. Exit code 2.</summary>
public sealed class UsageException(string message) : Exception(message);
