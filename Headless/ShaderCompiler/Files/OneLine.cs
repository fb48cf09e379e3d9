using System.Text;

namespace Headless.Files;

/// <summary>Text of a file or a flag as a message may show it: printable, on one line, not longer than a reader can use.</summary>
public static class OneLine
{
    private const int LongestMessage = 1000;
    private const int LongestValue = 60;

    /// <summary>A whole message.</summary>
    public static string Message(string text) => Shorten(text, LongestMessage);

    /// <summary>A value found in a file: <c>found '{Value(text)}'</c>.</summary>
    public static string Value(string text) => Shorten(text, LongestValue);

    private static string Shorten(string text, int longest)
    {
        var line = new StringBuilder();
        foreach (char c in text.AsSpan().Trim())
        {
            if (line.Length >= longest) return line.Append("... (").Append(text.Length).Append(" characters)").ToString();
            if (c is '\r') continue;
            line.Append(c == '\n' || c == '\t' ? ' ' : char.IsControl(c) || c is '\u2028' or '\u2029' ? '\uFFFD' : c);
        }
        return line.ToString();
    }
}
