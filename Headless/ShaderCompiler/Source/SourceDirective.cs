namespace Headless.Shaders;

/// <summary>A line that begins with #, with the lines that a backslash joins to it.</summary>
/// <param name="Argument">What follows the word, without comments.</param>
/// <param name="Written">What follows the word as it is written.</param>
internal readonly record struct SourceDirective(string Word, string Argument, string Written)
{
    public static SourceDirective Read(ReadOnlySpan<string> lines)
    {
        string body = lines.Length == 1 ? lines[0] : string.Join("\n", lines.ToArray()).Replace("\\\n", " ", StringComparison.Ordinal);
        body = body.TrimStart()[1..].TrimStart();
        int end = 0;
        while (end < body.Length && (char.IsLetterOrDigit(body[end]) || body[end] == '_')) end++;
        return new SourceDirective(body[..end], CommentState.WithoutComments(body[end..]).Trim(), body[end..].Trim());
    }

    /// <summary>The file of <c>"file"</c> or <c>&lt;file&gt;</c>; null for anything else.</summary>
    public static string? IncludedFile(string argument)
    {
        int end = argument.Length < 2 ? -1 : argument[0] switch
        {
            '"' => argument.IndexOf('"', 1),
            '<' => argument.IndexOf('>', 1),
            _ => -1,
        };
        return end < 0 ? null : argument[1..end];
    }
}
