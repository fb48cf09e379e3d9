using System.Text;

namespace Headless.Help;

/// <summary>What <c>./run --help</c> shows.</summary>
internal static class HelpText
{
    private const int Indent = HelpColumns.Indent;

    private const string AllVerbs = """
        Messages begin with the verb. Unknown flags, wrong values and missing files: one line and exit code 2; no file changes.
        Errors in the console, among them a liquid that is refused: exit code 1, the frames and no film; a play whose liquids were all
        refused ends at once. Exit code 1 also where choose has no answer, merge lacks runs, export leaves a liquid out, or standard
        output cannot be written. Ctrl-C ends a run within a second or so, leaves valid files (the film of the frames so far) and gives
        exit code 130. DIR is a new or empty folder, or one that was written to before: only files that the player or a measurement
        wrote there are replaced, and another run has to wait for its end.
        """;

    /// <summary>All verbs and all flags.</summary>
    public static string Overview(IReadOnlyList<Verb> verbs)
    {
        var text = new StringBuilder();
        HelpColumns.Entry(text, "./run", "plays the sample scene Dam Break: the same as ./run play");
        foreach (Verb verb in verbs) HelpColumns.Entry(text, $"./run {verb.Name}{(verb.Words.Length > 0 ? " " + verb.Words : "")}", verb.Summary);
        HelpColumns.Entry(text, "./run VERB --help", "a verb's flags, with examples");
        HelpColumns.Entry(text, "./run --help", "this text");
        HelpColumns.Entry(text, "./run --version", "the package's version, and the commit with a + where files differ from it");
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
