namespace Headless.Importers;

/// <summary>An asset cannot be read: the message names the file, the place in it and the cure.</summary>
public sealed class ImportException : Exception
{
    public ImportException(string message) : base(message) { }
    public ImportException(string message, Exception inner) : base(message, inner) { }
}
