using System.Text;

namespace Headless.Help;

/// <summary>What <c>./run --help</c> shows.</summary>
internal static class HelpText
{
    private const int Indent = HelpColumns.Indent;

    private const string AllVerbs = """
        Messages begin with the verb. Unknown flags, wrong values and missing files: one line and exit code 2.
        Errors in the console: exit code 1, the frames and no film. Ctrl-C ends a run within a second or so, leaves valid files
        (the film of the frames so far) and gives exit code 130. In DIR only files that the player or a measurement wrote are
        replaced; where others have their names, nothing is played or measured.
        """;

    /// <summary>All verbs and all flags.</summary>
    public static string Overview(IReadOnlyList<Verb> verbs)
    {
        var text = new StringBuilder();
        HelpColumns.Entry(text, "./run", "plays the sample scene Dam Break: the same as ./run play");
        foreach (Verb verb in verbs) HelpColumns.Entry(text, $"./run {verb.Name}{(verb.Words.Length > 0 ? " " + verb.Words : "")}", verb.Summary);
        HelpColumns.Entry(text, "./run VERB --help", "a verb's flags, with examples");
        HelpColumns.Entry(text, "./run --help", "this text");
        text.Append("\nIn brackets: what holds without the flag.\n");
        foreach (Verb verb in verbs.Where(v => v.AllFlags.Any()))
        {
            text.Append('\n').Append(verb.Name).Append('\n');
            Body(text, verb);
        }
        text.Append('\n');
        HelpColumns.Paragraph(text, AllVerbs, 0);
        return text.ToString();
    }

    /// <summary>One verb.</summary>
    public static string Of(Verb verb)
    {
        var text = new StringBuilder();
        text.Append($"./run {verb.Name} {verb.Words}".TrimEnd()).Append('\n');
        HelpColumns.Paragraph(text, verb.Summary, Indent);
        if (verb.AllFlags.Any() || verb.Notes.Count > 0) text.Append('\n');
        Body(text, verb);
        if (verb.Examples.Count > 0) text.Append("\nexamples\n");
        foreach (var (words, meaning) in verb.Examples)
        {
            text.Append(' ', Indent).Append($"./run {verb.Name} {words}".TrimEnd()).Append('\n');
            HelpColumns.Paragraph(text, meaning, 3 * Indent);
        }
        return text.ToString();
    }

    private static void Body(StringBuilder text, Verb verb)
    {
        foreach (Flag flag in verb.Flags) HelpColumns.Flag(text, flag);
        foreach (string note in verb.Notes) HelpColumns.Paragraph(text, note, Indent);
        if (verb.Other is not { } other) return;
        HelpColumns.Paragraph(text, other.Sentence, Indent);
        foreach (Flag flag in other.Flags) HelpColumns.Flag(text, flag);
    }
}
