using System.Text.RegularExpressions;

namespace Headless.Shaders;

/// <summary>Where a place of a stage's text comes from, by the "#line LINE FILE" directives in it.</summary>
internal static partial class SourceLines
{
    /// <param name="at">Index into the text.</param>
    public static (string File, int Line) Position(StageJob job, int at)
    {
        MatchCollection marks = Directive().Matches(job.Text[..at]);
        if (marks.Count == 0)
        {
            return (job.Source.Files[0], 0);
        }
        Match last = marks[^1];
        int after = job.Text[last.Index..at].Count(c => c == '\n') - 1;
        return (job.Source.FileName(int.Parse(last.Groups[2].Value)), int.Parse(last.Groups[1].Value) + after);
    }

    /// <summary>The same for a line of the text, counted from 1.</summary>
    public static (string File, int Line) OfLine(StageJob job, int line)
    {
        int at = 0;
        for (int i = 1; i < line && at >= 0; i++)
        {
            at = job.Text.IndexOf('\n', at) + 1;
        }
        return Position(job, at);
    }

    /// <summary>The job with a text in which lines count from its beginning: what the compiler says of lines then holds for the whole.</summary>
    public static StageJob CountedFromTheTop(StageJob job) => job with { Text = Directive().Replace(job.Text, "") };

    [GeneratedRegex(@"^#line (\d+) (\d+)$", RegexOptions.Multiline)]
    private static partial Regex Directive();
}
