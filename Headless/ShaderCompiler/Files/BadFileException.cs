namespace Headless.Files;

/// <summary>A file of the project that cannot be used. The message is one line: file, line, what is wrong, what to do.</summary>
public class BadFileException(string message, Exception? inner = null) : Exception(OneLine.Message(message), inner);
