using System.Text;

namespace Headless.CommandLine;

/// <summary>Help in two columns, names and what they mean, in lines of at most a hundred letters.</summary>
public static class HelpColumns
{
    /// <summary>In front of a flag.</summary>
    public const int Indent = 2;

    private const int Width = 100, NameColumn = 26;

    /// <summary>A flag: "--size WxH  size of the pictures in pixels [960x540]".</summary>
    public static void Flag(StringBuilder text, Flag flag)
    {
        string choices = flag.Choices.Count > 0 ? ": " + string.Join(" | ", flag.Choices) : "";
        string absent = flag.Absent is null ? "" : $" [{flag.Absent}]";
        Entry(text, new string(' ', Indent) + flag.Name + (flag.Value is null ? "" : " " + flag.Value), flag.Text + choices + absent);
    }

    /// <summary>A name, and what it means in a column of its own.</summary>
    public static void Entry(StringBuilder text, string name, string meaning)
    {
        text.Append(name);
        if (name.Length > NameColumn - 2) text.Append('\n').Append(' ', NameColumn);
        else text.Append(' ', NameColumn - name.Length);
        text.AppendJoin("\n" + new string(' ', NameColumn), Lines(meaning, Width - NameColumn)).Append('\n');
    }

    /// <summary>Sentences from edge to edge.</summary>
    public static void Paragraph(StringBuilder text, string sentences, int indent)
    {
        foreach (string line in Lines(sentences, Width - indent)) text.Append(' ', indent).Append(line).Append('\n');
    }

    private static IEnumerable<string> Lines(string text, int width)
    {
        var line = new StringBuilder();
        foreach (string word in text.Split([' ', '\n'], StringSplitOptions.RemoveEmptyEntries))
        {
            if (line.Length > 0 && line.Length + 1 + word.Length > width)
            {
                yield return line.ToString();
                line.Clear();
            }
            if (line.Length > 0) line.Append(' ');
            line.Append(word);
        }
        yield return line.ToString();
    }
}
