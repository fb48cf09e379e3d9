using Headless.Vulkan;

namespace Headless.Checks.Gpu;

/// <summary>What RADV made of the package's shaders: a table of the programs, and one of the hot loops.</summary>
internal sealed class CompiledTables
{
    public const string Spills = "vgpr_spills", ScalarSpills = "sgpr_spills", Scratch = "scratch_bytes", Lds = "lds_bytes",
        Waves = "waves", Instructions = "instructions", Cycles = "valu_cycles";

    private const string ProgramFile = "programs.csv", LoopFile = "loops.csv";

    private static readonly string[] programKey = ["family", "file", "entry", "keywords", "program"];
    private static readonly string[] loopKey = ["family", "file", "entry", "keywords", "loop"];

    // Column and RADV's name of it. Waves are RADV's "Subgroups per SIMD": on RDNA of a pair of SIMDs, so 32 at best, on GCN 10.
    private static readonly (string Column, string Statistic)[] statistics =
    [
        ("vgprs", "VGPRs"), ("sgprs", "SGPRs"), (Spills, "Spilled VGPRs"), (ScalarSpills, "Spilled SGPRs"), (Scratch, "Scratch size"),
        (Lds, "LDS size"), (Waves, "Subgroups per SIMD"), (Instructions, "Instructions"), ("code_bytes", "Code size"),
    ];

    private static readonly string[] programColumns = ["wave", .. statistics.Select(s => s.Column)];

    private static readonly string[] loopColumns =
    [
        Cycles, Instructions, "valu", "transcendental", "integer_product", "scalar", "branch", "scalar_load", "vector_load",
        "vector_store", "atomic", "groupshared", "wait",
    ];

    public static IReadOnlyList<FigureRule> ProgramRules { get; } =
    [
        new(Spills, Fails: true), new(ScalarSpills, Fails: true), new(Scratch, Fails: true), new(Lds, Fails: true),
        new(Waves, Fails: true, MoreIsBetter: true), new(Instructions, Fails: false, Percent: 5),
    ];

    public static IReadOnlyList<FigureRule> LoopRules { get; } = [new(Cycles, Fails: true, Percent: 5)];

    public CompiledTables(string toolchain) =>
        (Programs, Loops) = (new FigureTable(toolchain, programKey, programColumns), new FigureTable(toolchain, loopKey, loopColumns));

    private CompiledTables(FigureTable programs, FigureTable loops) => (Programs, Loops) = (programs, loops);

    public FigureTable Programs { get; }
    public FigureTable Loops { get; }

    public static bool Exist(string folder) => File.Exists(Path.Combine(folder, ProgramFile)) && File.Exists(Path.Combine(folder, LoopFile));

    /// <exception cref="FormatException">A file is no such table; the message names file and line.</exception>
    public static CompiledTables Read(string folder) => new(
        FigureTable.Read(Path.Combine(folder, ProgramFile), programKey, programColumns),
        FigureTable.Read(Path.Combine(folder, LoopFile), loopKey, loopColumns));

    public void Write(string folder)
    {
        Programs.Write(Path.Combine(folder, ProgramFile));
        Loops.Write(Path.Combine(folder, LoopFile));
    }

    /// <summary>Only the rows of one family.</summary>
    public CompiledTables Of(GpuFamily family)
    {
        var part = new CompiledTables(Programs.Toolchain);
        Copy(Programs, part.Programs);
        Copy(Loops, part.Loops);
        return part;

        void Copy(FigureTable from, FigureTable to)
        {
            foreach (var (key, figures) in from.Rows.Where(row => row.Key.StartsWith(family.Name + ",", StringComparison.Ordinal)))
                to.Rows.Add(key, figures);
        }
    }

    /// <summary>The row of a program.</summary>
    /// <exception cref="KeyNotFoundException">This driver does not report one of the figures.</exception>
    public static string ProgramLine(GpuFamily family, string variantKey, GpuExecutable program) => FigureTable.Line(
        $"{family.Name},{variantKey},{program.Name}",
        [program.SubgroupSize, .. statistics.Select(s => (int)program.Statistics[s.Statistic])]);

    /// <summary>The row of a loop.</summary>
    public static string LoopLine(GpuFamily family, string variantKey, string loop, InstructionCounts c) => FigureTable.Line(
        $"{family.Name},{variantKey},{loop}",
        [
            family.Cycles(c), c.Total, c.Valu, c.Transcendental, c.IntegerProduct, c.Scalar, c.Branches, c.ScalarLoads, c.VectorLoads,
            c.VectorStores, c.Atomics, c.Groupshared, c.Waits,
        ]);
}
