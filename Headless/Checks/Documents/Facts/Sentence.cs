using System.Text.RegularExpressions;

namespace Headless.Checks.Documents.Facts;

/// <summary>A sentence of a document as it is read, without the marks of links and comments, and its line; a row of a table is one.</summary>
internal sealed partial record Sentence(string Text, int Line, bool IsListed)
{
    /// <param name="markdown">The document, with its facts or without.</param>
    public static IEnumerable<Sentence> Of(string markdown)
    {
        var text = Fence().Replace(Comment().Replace(markdown, Blanks), Blanks);
        foreach (Match block in Block().Matches(text))
            foreach (Match sentence in End().Matches(block.Value))
            {
                var words = Space().Replace(Link().Replace(sentence.Value, "$1"), " ").Trim();
                var start = block.Index + sentence.Index + sentence.Value.Length - sentence.Value.TrimStart().Length;
                if (words.Length > 1) yield return new Sentence(words, text.AsSpan(0, start).Count('\n') + 1, block.Value.TrimStart().StartsWith("- ", StringComparison.Ordinal));
            }
    }

    private static string Blanks(Match match) => NoLineEnd().Replace(match.Value, " ");

    [GeneratedRegex(@"<!--[\s\S]*?-->")] private static partial Regex Comment();
    [GeneratedRegex(@"^ *```[\s\S]*?^ *```[^\n]*", RegexOptions.Multiline)] private static partial Regex Fence();
    // A row, or lines up to a blank one, the next item of a list, a heading or a table.
    [GeneratedRegex(@"^ *\|[^\n]*|^ *[^\s|][^\n]*(?:\n(?! *(?:[-*] |#|\||\d+\. ))[^\n]*\S[^\n]*)*", RegexOptions.Multiline)] private static partial Regex Block();
    [GeneratedRegex(@"[\s\S]+?(?:(?<=[^\s.])[.!?](?:\*\*)?(?=\s+[A-Z*`\[(])|\z)")] private static partial Regex End();
    [GeneratedRegex(@"!?\[([^\]]*)\]\([^()\s]*\)")] private static partial Regex Link();
    [GeneratedRegex(@"\s+")] private static partial Regex Space();
    [GeneratedRegex(@"[^\n]")] private static partial Regex NoLineEnd();
}
