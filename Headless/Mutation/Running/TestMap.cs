using System.Globalization;

namespace Headless.Mutation.Running;

/// <summary>What the player recorded of one test.</summary>
internal sealed record MappedTest(string Name, double Seconds, IReadOnlyList<string> Kernels, IReadOnlyList<string> Methods);

/// <summary>Which tests cover which kernel variant and which method: what <c>sphplayer test --coverage</c> wrote, with the names of methods for marks.</summary>
internal sealed class TestMap
{
    private readonly ILookup<string, MappedTest> byKernel;
    private readonly ILookup<string, MappedTest> byMethod;

    public TestMap(string file)
    {
        Tests = [.. File.ReadLines(file).Select(l => l.Split('\t')).Where(f => f.Length == 5 && f[1] == "Passed").Select(Read)];
        byKernel = Tests.SelectMany(t => t.Kernels.Select(k => (k, t))).ToLookup(p => p.k, p => p.t, StringComparer.Ordinal);
        byMethod = Tests.SelectMany(t => t.Methods.Select(m => (m, t))).ToLookup(p => p.m, p => p.t, StringComparer.Ordinal);
    }

    public IReadOnlyList<MappedTest> Tests { get; }

    /// <summary>Variants that some test dispatches, as "path of the shader|kernel|keywords".</summary>
    public IEnumerable<string> Kernels => byKernel.Select(g => g.Key);

    public IReadOnlyList<MappedTest> OfKernels(IEnumerable<string> kernels) => [.. kernels.SelectMany(k => byKernel[k]).Distinct()];

    public IReadOnlyList<MappedTest> OfMethods(IEnumerable<string> methods) => [.. methods.SelectMany(m => byMethod[m]).Distinct()];

    /// <summary>Puts what the player recorded in place of what the map knew of the same tests.</summary>
    /// <param name="name">The method of a mark.</param>
    public static void Merge(string map, string recorded, Func<int, string> name)
    {
        var lines = new Dictionary<string, string>(StringComparer.Ordinal);
        if (File.Exists(map))
            foreach (string line in File.ReadLines(map)) lines[line.Split('\t')[0]] = line;
        foreach (string[] fields in File.ReadLines(recorded).Select(l => l.Split('\t')).Where(f => f.Length == 5))
        {
            fields[4] = string.Join(' ', fields[4].Split(' ', StringSplitOptions.RemoveEmptyEntries).Select(m => name(int.Parse(m, CultureInfo.InvariantCulture))));
            lines[fields[0]] = string.Join('\t', fields);
        }
        File.WriteAllLines(map, lines.Values);
        File.Delete(recorded);
    }

    private static MappedTest Read(string[] fields) => new(
        fields[0], double.Parse(fields[2], CultureInfo.InvariantCulture),
        fields[3].Split(';', StringSplitOptions.RemoveEmptyEntries),
        fields[4].Split(' ', StringSplitOptions.RemoveEmptyEntries));
}
