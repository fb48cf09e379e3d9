using System.Text.RegularExpressions;

namespace Headless.Checks.Documents.Facts;

/// <summary>
/// A fact in a document, which its readers do not see as one: <c>&lt;!--fact:count:cases--&gt;19&lt;!--/--&gt;</c>. A value of several lines, such as a table, has
/// blank lines about it.
/// </summary>
internal sealed partial record FactMarker(string Name, string Value, int Index)
{
    public static IEnumerable<FactMarker> In(string text) => Marker().Matches(text).Select(m => new FactMarker(m.Groups["name"].Value, m.Groups["value"].Value, m.Index));

    /// <summary>The text with the value of each fact that is known.</summary>
    public static string Update(string text, Func<string, string?> value) =>
        Marker().Replace(text, m => value(m.Groups["name"].Value) is { } known ? $"<!--fact:{m.Groups["name"].Value}-->{Written(known)}<!--/-->" : m.Value);

    /// <summary>The text without its facts, in as many characters; lines stay.</summary>
    public static string Blank(string text) => Marker().Replace(text, m => NoLineEnd().Replace(m.Value, " "));

    /// <summary>The text with values and without markers.</summary>
    public static string Read(string text) => Marker().Replace(text, m => m.Groups["value"].Value);

    /// <summary>A value as it stands between its markers.</summary>
    public static string Written(string value) => value.Contains('\n') ? $"\n\n{value.Trim('\n')}\n\n" : value;

    /// <summary>How many markers begin or end without the other half.</summary>
    public static int Unpaired(string text) => Half().Count(Marker().Replace(text, ""));

    /// <summary>Places where an inline fact begins a line: what follows would be shown as it is written, without emphasis and links.</summary>
    public static IEnumerable<int> AtLineStart(string text) => Start().Matches(text).Select(m => m.Index);

    [GeneratedRegex(@"<!--fact:(?<name>[^\s>]+)-->(?<value>(?:(?!<!--fact:)[\s\S])*?)<!--/-->")] private static partial Regex Marker();
    [GeneratedRegex(@"<!--fact:|<!--/-->")] private static partial Regex Half();
    [GeneratedRegex(@"^ {0,3}<!--fact:[^\s>]+-->(?=[^\n])", RegexOptions.Multiline)] private static partial Regex Start();
    [GeneratedRegex(@"[^\n]")] private static partial Regex NoLineEnd();
}
