namespace Headless.CommandLine;

/// <summary>What somebody may have meant who mistyped a word.</summary>
public static class Suggestion
{
    /// <summary>The end of a sentence: "; did you mean --size?", or a full stop where nothing is near.</summary>
    public static string Question(string word, IEnumerable<string> known) => Nearest(word, known) is { } nearest ? $"; did you mean {nearest}?" : ".";

    /// <summary>
    /// The word with the fewest letters to insert, drop, replace or swap with the next one: "--szie" is one swap from "--size". Null where
    /// more than a third of the letters differ.
    /// </summary>
    internal static string? Nearest(string word, IEnumerable<string> known)
    {
        int most = Math.Max(1, word.TrimStart('-').Length / 3);
        return known.Select(k => (Word: k, Distance: Distance(word, k))).Where(k => k.Distance <= most).OrderBy(k => k.Distance).FirstOrDefault().Word;
    }

    /// <summary>Optimal string alignment distance.</summary>
    private static int Distance(string a, string b)
    {
        int[] beforeLast = [], last = [.. Enumerable.Range(0, b.Length + 1)];
        for (int i = 1; i <= a.Length; i++)
        {
            int[] row = new int[b.Length + 1];
            row[0] = i;
            for (int j = 1; j <= b.Length; j++)
            {
                row[j] = Math.Min(last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1), Math.Min(last[j], row[j - 1]) + 1);
                if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = Math.Min(row[j], beforeLast[j - 2] + 1);
            }
            (beforeLast, last) = (last, row);
        }
        return last[^1];
    }
}
