using System.Globalization;

namespace Headless.Mutation;

/// <summary>One change of a source file: the text from <paramref name="Start"/> is replaced.</summary>
/// <param name="File">Path below the package's folder.</param>
/// <param name="Source">The changed line without its indentation.</param>
internal record Mutant(string File, int Line, string Operator, string Source, int Column, int Start, string Original, string Replacement)
{
    /// <summary>What is changed, with its column in <see cref="Source"/>, as "12: '&lt;' -> '&lt;='".</summary>
    public virtual string Change => string.Create(CultureInfo.InvariantCulture, $"{Column}: '{OneLine(Original)}' -> '{OneLine(Replacement)}'");

    /// <summary>The same for the same change of the same text, wherever the line has moved to.</summary>
    public string Key => $"{File}\n{Source}\n{Change}";

    public static Mutant Create(string file, string text, string kind, int start, int length, string replacement)
    {
        int lineStart = start == 0 ? 0 : text.LastIndexOf('\n', start - 1) + 1;
        int lineEnd = text.IndexOf('\n', start);
        string line = text[lineStart..(lineEnd < 0 ? text.Length : lineEnd)];
        int indent = line.Length - line.TrimStart().Length;
        int number = text.AsSpan(0, start).Count('\n') + 1;
        return new Mutant(file, number, kind, line.Trim(), start - lineStart - indent + 1, start, text.Substring(start, length), replacement);
    }

    public string Apply(string text) => text[..Start] + Replacement + text[(Start + Original.Length)..];

    private static string OneLine(string text) => string.Join(' ', text.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries));
}

/// <summary>A change as a table keeps it: enough to know it again, not to make it.</summary>
internal sealed record StoredMutant(string File, int Line, string Operator, string Source, string Text) : Mutant(File, Line, Operator, Source, 0, 0, "", "")
{
    public override string Change => Text;
}
