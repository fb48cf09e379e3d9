namespace Headless.Bench;

/// <summary>A flag or a file of the command line is wrong; the message says which and what to do.</summary>
internal sealed class UsageException(string message) : Exception(message);
