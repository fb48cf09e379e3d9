using Headless.Files;

namespace Headless.Importers;

/// <summary>An asset cannot be read: the message names the file, the place in it and the cure.</summary>
public sealed class ImportException : BadFileException
{
    private const string UsualCure = "Correct it, or restore the file from version control.";

    public ImportException(string message) : base(message) { }
    public ImportException(string message, Exception inner) : base(message, inner) { }

    /// <param name="place">File, and line where there is one: <c>Assets/A.unity:12</c>.</param>
    public static ImportException At(string place, string problem, string cure = UsualCure, Exception? inner = null)
    {
        string message = place.Length > 0 ? $"{place}: {problem} {cure}" : $"{problem} {cure}";
        return inner is null ? new ImportException(message) : new ImportException(message, inner);
    }
}
