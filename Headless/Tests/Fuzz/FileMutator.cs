using System.Text;

namespace Headless.Tests.Fuzz;

/// <summary>Breaks a file as disks, merges, editors and attackers do; the same seed gives the same break.</summary>
internal sealed class FileMutator(Random random)
{
    private const int LargestGrowth = 4 << 20;

    private static readonly string[] Numbers =
    [
        "abc", "0x10", "1_000", "99999999999999999999999", "-1", "0", "1e400", "-1e30", "NaN", "Infinity", "2147483648", "4294967296", "9223372036854775808",
        "1.5", "1,5", "", "''", "~", "null", "true", "{fileID: 1}", "[1, 2]", "\u0661", "--5", "1e-30", "65536", "1000000000",
    ];

    /// <param name="kind">How, for the name of a failure.</param>
    public byte[] Mutate(byte[] original, out string kind)
    {
        int count = 1 + random.Next(3);
        byte[] bytes = original;
        var kinds = new List<string>();
        for (int i = 0; i < count; i++)
        {
            bytes = Once(bytes, out string one);
            kinds.Add(one);
        }
        kind = string.Join('+', kinds);
        return bytes;
    }

    private byte[] Once(byte[] bytes, out string kind)
    {
        switch (random.Next(16))
        {
            case 0:
                kind = "flipped bytes";
                return Flip(bytes);
            case 1:
                kind = "cut off";
                return bytes[..random.Next(bytes.Length + 1)];
            case 2:
                kind = "NUL bytes";
                return Insert(bytes, new byte[1 + random.Next(64)]);
            case 3:
                kind = "random bytes";
                var noise = new byte[1 + random.Next(256)];
                random.NextBytes(noise);
                return Insert(bytes, noise);
            case 4:
                kind = "deleted lines";
                return Lines(bytes, lines =>
                {
                    int at = At(lines);
                    lines.RemoveRange(at, Math.Min(1 + random.Next(20), lines.Count - at));
                });
            case 5:
                kind = "doubled lines";
                return Lines(bytes, lines => lines.InsertRange(At(lines), lines.GetRange(At(lines), 1)));
            case 6:
                kind = "exchanged lines";
                return Lines(bytes, lines =>
                {
                    int a = At(lines), b = At(lines);
                    (lines[a], lines[b]) = (lines[b], lines[a]);
                });
            case 7:
                kind = "other indent";
                return Lines(bytes, lines => Change(lines, l => new string(' ', random.Next(40)) + l.TrimStart()));
            case 8:
                kind = "long line";
                return Lines(bytes, lines => Change(lines, l => l + new string((char)('!' + random.Next(90)), 10_000 << random.Next(8))));
            case 9:
                kind = "deep nesting";
                return Insert(bytes, Encoding.UTF8.GetBytes(Nested(10 << random.Next(13))));
            case 10:
                kind = "many lines";
                return Lines(bytes, lines => lines.InsertRange(At(lines), Repeated(lines[At(lines)])));
            case 11:
                kind = "continued lines";
                return Lines(bytes, lines => Change(lines, l => string.Join("\\\n", Repeated(l)) + "\\"));
            case 12:
                kind = "word of another line";
                return Lines(bytes, lines => Change(lines, l => ReplaceWord(l, _ => Word(lines[At(lines)]))));
            default:
                kind = "another value";
                return Lines(bytes, lines => Change(lines, l => ReplaceWord(l, w => random.Next(4) == 0 ? Word(lines[At(lines)]) : Numbers[random.Next(Numbers.Length)])));
        }
    }

    private byte[] Flip(byte[] bytes)
    {
        byte[] copy = [.. bytes];
        for (int i = 1 + random.Next(8); i > 0 && copy.Length > 0; i--) copy[random.Next(copy.Length)] ^= (byte)(1 << random.Next(8));
        return copy;
    }

    private byte[] Insert(byte[] bytes, byte[] more)
    {
        int at = random.Next(bytes.Length + 1);
        return [.. bytes[..at], .. more, .. bytes[at..]];
    }

    private string Nested(int depth) => random.Next(6) switch
    {
        0 => new string('[', depth),
        1 => new string('{', depth),
        2 => string.Concat(Enumerable.Repeat("{a: ", depth)),
        3 => string.Concat(Enumerable.Repeat("- ", depth)),
        4 => new string('(', depth),
        _ => string.Concat(Enumerable.Range(0, Math.Min(depth, 1000)).Select(i => new string(' ', i) + "a:\n")),
    };

    private static byte[] Lines(byte[] bytes, Action<List<string>> change)
    {
        var lines = new List<string>(Encoding.Latin1.GetString(bytes).Split('\n'));
        change(lines);
        return Encoding.Latin1.GetBytes(string.Join('\n', lines));
    }

    private int At(List<string> lines) => random.Next(lines.Count);

    private IEnumerable<string> Repeated(string line) => Enumerable.Repeat(line, Math.Min(1 << random.Next(15), LargestGrowth / (line.Length + 1)));

    private void Change(List<string> lines, Func<string, string> change)
    {
        int at = At(lines);
        lines[at] = change(lines[at]);
    }

    private string ReplaceWord(string line, Func<string, string> replace)
    {
        string[] words = line.Split(' ');
        int at = random.Next(words.Length);
        // "x: 1, y: 2": the value without what ends it.
        string end = string.Concat(words[at].Reverse().TakeWhile(c => c is ',' or '}' or ']' or ':').Reverse());
        words[at] = replace(words[at]) + end;
        return string.Join(' ', words);
    }

    private string Word(string line)
    {
        string[] words = line.Split(' ', StringSplitOptions.RemoveEmptyEntries);
        return words.Length == 0 ? "" : words[random.Next(words.Length)];
    }
}
