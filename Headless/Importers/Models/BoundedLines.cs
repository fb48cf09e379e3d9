using System.Text;

namespace Headless.Importers.Models;

/// <summary>
/// The statements of a line-based text: lines joined where one ends in a backslash, without comments. Bounds the length of a
/// statement and the lines it goes over.
/// </summary>
internal sealed class BoundedLines(TextReader reader, string path)
{
    private const int LongestStatement = 1 << 20;
    private const int MostContinuations = 10_000;

    private readonly StringBuilder statement = new();
    private int line;

    /// <summary>Line on which the last statement began.</summary>
    public int First { get; private set; }

    /// <returns>Null at the end.</returns>
    public string? Next()
    {
        statement.Clear();
        First = line + 1;
        if (reader.Peek() < 0) return null;
        for (int lines = 1; ReadLine(); lines++)
        {
            if (lines > MostContinuations)
                throw new ImportException($"{path}:{First}: a statement goes on over more than {MostContinuations} lines. Write it on fewer, or export the model again.");
            statement[^1] = ' ';
        }
        return statement.ToString();
    }

    /// <returns>Whether the line ends in a backslash and another one follows.</returns>
    private bool ReadLine()
    {
        line++;
        for (int c = reader.Read(); c >= 0 && c != '\n'; c = reader.Read())
        {
            if (statement.Length >= LongestStatement)
                throw new ImportException($"{path}:{First}: a statement has more than {LongestStatement} characters. Export the model again, with triangles or quadrilaterals.");
            if (c != '\r') statement.Append((char)c);
        }
        return statement.Length > 0 && statement[^1] == '\\' && reader.Peek() >= 0;
    }
}
