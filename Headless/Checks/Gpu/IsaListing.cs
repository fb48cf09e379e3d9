using System.Text.RegularExpressions;

namespace Headless.Checks.Gpu;

/// <summary>An assembly listing of RADV: its operations in order and its loops.</summary>
/// <remarks>Lines are "BB3:", "\tv_add_f32_e32 v1, v2, v3 ; 06020702" and, for a run of equal words, "(then repeated 4 times)".</remarks>
internal sealed partial class IsaListing
{
    private readonly List<string> operations = [];
    private readonly List<(int First, int Last)> loops = [];

    private IsaListing() { }

    public IReadOnlyList<string> Operations => operations;

    /// <summary>Loops that contain no other, in order of their first instruction.</summary>
    public IEnumerable<InstructionCounts> InnerLoops() => loops
        .Where(loop => !loops.Exists(other => other != loop && other.First >= loop.First && other.Last <= loop.Last))
        .Select(loop => InstructionCounts.Of(operations[loop.First..(loop.Last + 1)]));

    public static IsaListing Parse(string text)
    {
        var listing = new IsaListing();
        var labels = new Dictionary<string, int>();
        var jumps = new List<(int From, string To)>();
        foreach (var raw in text.Split('\n'))
        {
            var line = raw.Split(';')[0].Trim();
            if (Label().Match(line) is { Success: true } label) labels[label.Groups[1].Value] = listing.operations.Count;
            else if (Repeat().Match(line) is { Success: true } repeat)
                listing.operations.AddRange(Enumerable.Repeat(listing.operations[^1], int.Parse(repeat.Groups[1].Value)));
            else if (Instruction().Match(line) is { Success: true } instruction)
            {
                if (Jump().Match(line) is { Success: true } jump) jumps.Add((listing.operations.Count, jump.Groups[1].Value));
                listing.operations.Add(instruction.Groups[1].Value);
            }
        }
        // A loop is a jump back; several jumps back to one place ("continue") are one loop, up to the last of them.
        listing.loops.AddRange(
            from jump in jumps
            where labels.TryGetValue(jump.To, out var target) && target <= jump.From
            group jump.From by labels[jump.To] into loop
            orderby loop.Key
            select (loop.Key, loop.Max()));
        return listing;
    }

    [GeneratedRegex(@"^(BB\d+):")]
    private static partial Regex Label();

    [GeneratedRegex(@"^\(then repeated (\d+) times\)")]
    private static partial Regex Repeat();

    [GeneratedRegex(@"^([a-z]+_\w+|exp)(\s|$)")]
    private static partial Regex Instruction();

    [GeneratedRegex(@"^s_c?branch\w*\s+(BB\d+)")]
    private static partial Regex Jump();
}
