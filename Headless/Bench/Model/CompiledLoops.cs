using System.Globalization;

namespace Headless.Bench.Model;

/// <summary>Instructions of a turn of a loop, and what a family of GPUs needs to issue them for a wave of 64.</summary>
internal sealed record CompiledLoop(int Cycles, int Valu, int Transcendental, int IntegerProduct, int Branches, int ScalarLoads, int Memory, int Groupshared);

/// <summary>The table of hot loops that <c>./run check --only gpu</c> holds.</summary>
internal sealed class CompiledLoops
{
    private readonly Dictionary<string, CompiledLoop> loops = [];

    private CompiledLoops(string compiler) => Compiler = compiler;

    /// <summary>What compiled them.</summary>
    public string Compiler { get; }

    /// <exception cref="UsageException">The file is no such table.</exception>
    public static CompiledLoops Read(string file)
    {
        string[] lines = File.Exists(file) ? File.ReadAllLines(file) : [];
        if (lines.Length < 2) throw new UsageException($"'{file}' is no table of hot loops; ./run check --only gpu --update writes it.");
        var table = new CompiledLoops(lines[0].TrimStart('#', ' '));
        string[] names = lines[1].Split(',');
        foreach (string[] cells in lines.Skip(2).Select(line => line.Split(',')))
        {
            int Cell(string name) => int.Parse(cells[Array.IndexOf(names, name)], CultureInfo.InvariantCulture);
            table.loops[Key(cells[0], cells[2], cells[3], cells[4])] = new CompiledLoop(
                Cell("valu_cycles"), Cell("valu"), Cell("transcendental"), Cell("integer_product"), Cell("branch"), Cell("scalar_load"),
                Cell("vector_load") + Cell("vector_store") + Cell("atomic"), Cell("groupshared"));
        }
        return table;
    }

    /// <exception cref="UsageException">The table has no such loop.</exception>
    public CompiledLoop this[string family, string kernel, string keywords, string loop] =>
        loops.TryGetValue(Key(family, kernel, keywords, loop), out CompiledLoop? found) ? found
            : throw new UsageException($"the table of hot loops has no '{loop}' of {kernel} [{keywords}] for {family}; benchmarks/model/loops.csv asks for it.");

    private static string Key(string family, string kernel, string keywords, string loop) => $"{family},{kernel},{keywords},{loop}";
}
