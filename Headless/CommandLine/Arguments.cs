using System.Globalization;
using Headless.Files;

namespace Headless.CommandLine;

/// <summary>The flags of one command. Each flag is declared before it is read; the first one that is unknown, repeated or without its value is an error.</summary>
public sealed class Arguments
{
    private readonly Dictionary<string, string?> values = new(StringComparer.Ordinal);

    /// <param name="command">For messages.</param>
    /// <param name="words">Everything after the command's name.</param>
    /// <param name="flags">The flags that it has.</param>
    public Arguments(string command, IReadOnlyList<string> words, IReadOnlyCollection<Flag> flags)
    {
        for (int i = 0; i < words.Count; i++)
        {
            string word = words[i];
            if (word == "--")
            {
                Extra = [.. words.Skip(i + 1)];
                return;
            }
            string? inline = null;
            int equals = word.IndexOf('=');
            if (word.StartsWith("--", StringComparison.Ordinal) && equals > 0) (word, inline) = (word[..equals], word[(equals + 1)..]);
            if (values.ContainsKey(word)) throw new UsageException($"{word} is given twice.");
            Flag flag = flags.FirstOrDefault(f => f.Name == word) ?? throw new UsageException(Unknown(command, word, flags));
            if (flag.Value is null)
            {
                if (inline is not null) throw new UsageException($"{word} takes no value, found '{OneLine.Value(inline)}'.");
                values[word] = null;
                continue;
            }
            if (inline is null && (i + 1 >= words.Count || words[i + 1].StartsWith("--", StringComparison.Ordinal))) throw new UsageException($"{word} needs a value.");
            values[word] = inline ?? words[++i];
            if (string.IsNullOrWhiteSpace(values[word])) throw new UsageException($"{word} must not be empty.");
            if (flag.Choices.Count > 0 && !flag.Choices.Contains(values[word])) throw new UsageException(NoChoice(flag, values[word]!));
        }
    }

    /// <summary>What follows <c>--</c>: for the project's own code.</summary>
    public IReadOnlyList<string> Extra { get; } = [];

    public bool Has(string flag) => values.ContainsKey(flag);

    public string Text(string flag, string absent) => values.GetValueOrDefault(flag) ?? absent;

    public string? Text(string flag) => values.GetValueOrDefault(flag);

    public string Required(string flag) => Text(flag) ?? throw new UsageException($"{flag} is missing.");

    public double Number(string flag, double absent, double least, double most, string unit)
    {
        if (Text(flag) is not { } text) return absent;
        if (double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value) && value >= least && value <= most) return value;
        throw new UsageException(string.Create(CultureInfo.InvariantCulture, $"{flag} must be a number of {unit} from {least} to {most}, found '{OneLine.Value(text)}'."));
    }

    public int Whole(string flag, int absent, int least = 0)
    {
        if (Text(flag) is not { } text) return absent;
        if (int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int value) && value >= least) return value;
        throw new UsageException($"{flag} must be a whole number{(least > 0 ? $" of {least} or more" : "")}, found '{OneLine.Value(text)}'.");
    }

    public string Folder(string flag)
    {
        string folder = Required(flag);
        return Directory.Exists(folder) ? folder : throw new UsageException($"{flag}: the folder '{OneLine.Value(folder)}' does not exist.");
    }

    private static string NoChoice(Flag flag, string value) =>
        $"{flag.Name} must be one of {string.Join(", ", flag.Choices)}, found '{OneLine.Value(value)}'{Suggestion.Question(value, flag.Choices)}";

    private static string Unknown(string command, string word, IReadOnlyCollection<Flag> flags)
    {
        if (!word.StartsWith('-')) return $"'{OneLine.Value(word)}' is not understood by {command}: flags begin with --.";
        string[] names = [.. flags.Select(f => f.Name).Order(StringComparer.Ordinal)];
        string all = names.Length > 0 ? $"Its flags are {string.Join(", ", names)}." : "It has none.";
        return $"{OneLine.Value(word)} is not a flag of {command}{Suggestion.Question(word, names)} {all}";
    }
}
