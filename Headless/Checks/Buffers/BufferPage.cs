namespace Headless.Checks.Buffers;

/// <summary>The manual's table of storage buffers by part.</summary>
internal sealed class BufferPage(string path)
{
    private const string Head = "| Part | Storage buffers | of them written | In |";

    /// <summary>What differs between the page's rows and these.</summary>
    public IEnumerable<string> Compare(IReadOnlyList<string> rows)
    {
        if (Read() is not { } found) return [$"{Path.GetFileName(path)} has no table '{Head}'"];
        var held = found.Lines[found.First..found.End];
        return [.. rows.Except(held).Select(row => $"{Path.GetFileName(path)} lacks '{row}'"),
            .. held.Except(rows).Select(row => $"{Path.GetFileName(path)} says '{row}'")];
    }

    public void Write(IReadOnlyList<string> rows)
    {
        if (Read() is not { } found) return;
        File.WriteAllText(path, string.Join('\n', [.. found.Lines[..found.First], .. rows, .. found.Lines[found.End..]]));
    }

    public static string Row(string part, int buffers, int written, string shader) => $"| {part} | {buffers} | {written} | {shader} |";

    // Lines of the page, the first row of the table and the line behind its last.
    private (string[] Lines, int First, int End)? Read()
    {
        if (!File.Exists(path)) return null;
        var lines = File.ReadAllText(path).Split('\n');
        var head = Array.IndexOf(lines, Head);
        if (head < 0) return null;
        var end = head + 2;
        while (end < lines.Length && lines[end].StartsWith('|')) end++;
        return (lines, head + 2, end);
    }
}
