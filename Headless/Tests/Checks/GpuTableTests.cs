using Headless.Checks.Gpu;
using NUnit.Framework;

namespace Headless.Tests.Checks;

public sealed class GpuTableTests
{
    private const string Kernel = "NAVI21,Shaders/A.compute,A,FLUID_PERIODIC,Compute Shader";
    private const string Loop = "NAVI21,Shaders/A.compute,A,FLUID_PERIODIC,candidate";

    // wave, vgprs, sgprs, vgpr_spills, sgpr_spills, scratch_bytes, lds_bytes, waves, instructions, code_bytes
    private static readonly int[] good = [64, 40, 128, 0, 0, 0, 1024, 24, 1000, 5000];

    [TestCase(CompiledTables.Spills, 40)]
    [TestCase(CompiledTables.ScalarSpills, 1)]
    [TestCase(CompiledTables.Scratch, 10240)]
    [TestCase(CompiledTables.Lds, 1028)]
    [TestCase(CompiledTables.Waves, 20)]
    public void AWorseProgramFails(string column, int now)
    {
        TableComparison comparison = Compare(Programs((Kernel, good)), Programs((Kernel, With(column, now))), CompiledTables.ProgramRules);

        Assert.That(comparison.Findings, Is.EqualTo(new[]
        {
            $"NAVI21 Shaders/A.compute A FLUID_PERIODIC Compute Shader: {column} {good[Programs().IndexOf(column)]} -> {now}",
        }));
    }

    [TestCase(CompiledTables.Spills, -1)]
    [TestCase(CompiledTables.Lds, 0)]
    [TestCase(CompiledTables.Waves, 32)]
    [TestCase(CompiledTables.Instructions, 1050)]
    [TestCase("vgprs", 48)]
    [TestCase("code_bytes", 9000)]
    public void ABetterOrEqualProgramPasses(string column, int now)
    {
        TableComparison comparison = Compare(Programs((Kernel, good)), Programs((Kernel, With(column, now))), CompiledTables.ProgramRules);

        Assert.That(comparison.Findings.Concat(comparison.Notes), Is.Empty);
    }

    [Test]
    public void MoreInstructionsByFivePercentAreNoted()
    {
        TableComparison comparison = Compare(
            Programs((Kernel, good)), Programs((Kernel, With(CompiledTables.Instructions, 1051))), CompiledTables.ProgramRules);

        Assert.That(comparison.Findings, Is.Empty);
        Assert.That(comparison.Notes, Has.One.EndsWith("instructions 1000 -> 1051"));
    }

    [Test]
    public void KernelsThatAreMissingInTheTableOrLeftOverFail()
    {
        TableComparison comparison = Compare(
            Programs((Kernel, good)), Programs((Kernel.Replace("A.c", "B.c"), good)), CompiledTables.ProgramRules);

        Assert.That(comparison.Findings, Has.Count.EqualTo(2));
        Assert.That(comparison.Findings, Has.One.EndsWith("B.compute A FLUID_PERIODIC Compute Shader: not in the table"));
        Assert.That(comparison.Findings, Has.One.EndsWith("A.compute A FLUID_PERIODIC Compute Shader: in the table, but not compiled"));
    }

    [TestCase(105, false)]
    [TestCase(106, true)]
    public void AHotLoopFailsAboveFivePercent(int cycles, bool fails)
    {
        TableComparison comparison = Compare(Loops(100), Loops(cycles), CompiledTables.LoopRules);

        Assert.That(comparison.Findings, fails ? Has.One.EndsWith("valu_cycles 100 -> 106") : Is.Empty);
    }

    [Test]
    public void ATableIsReadAsItWasWrittenAndSorted()
    {
        string folder = Directory.CreateTempSubdirectory("table").FullName;
        var tables = new CompiledTables("Mesa 1.2.3, front 4");
        tables.Programs.Rows.Add("B,f,k,,Compute Shader", good);
        tables.Programs.Rows.Add("A,f,k,X Y,Compute Shader", good);
        tables.Loops.Rows.Add("A,f,k,,candidate", new int[13]);
        tables.Write(folder);

        CompiledTables read = CompiledTables.Read(folder);
        Assert.That(read.Programs.Toolchain, Is.EqualTo("Mesa 1.2.3, front 4"));
        Assert.That(read.Programs.Rows, Is.EqualTo(tables.Programs.Rows));
        Assert.That(File.ReadAllLines(Path.Combine(folder, "programs.csv"))[2], Does.StartWith("A,f,k,X Y,Compute Shader,64,40,"));
        Directory.Delete(folder, recursive: true);
    }

    [TestCase("A,f,k,,Compute Shader,1,2", "programs.csv(3)")]
    [TestCase("A,f,k,,Compute Shader,1,2,3,4,5,6,7,8,9,x", "programs.csv(3)")]
    [TestCase("", "first two lines")]
    public void ATableThatCannotBeReadIsNamed(string line, string place)
    {
        string folder = Directory.CreateTempSubdirectory("table").FullName;
        new CompiledTables("Mesa").Write(folder);
        string file = Path.Combine(folder, "programs.csv");
        File.WriteAllText(file, line.Length > 0 ? File.ReadAllText(file) + line + "\n" : "nothing\n");

        Assert.That(() => CompiledTables.Read(folder), Throws.TypeOf<FormatException>().With.Message.Contains(place));
        Directory.Delete(folder, recursive: true);
    }

    private static TableComparison Compare(FigureTable committed, FigureTable measured, IReadOnlyList<FigureRule> rules)
    {
        var comparison = new TableComparison(rules);
        comparison.Compare(committed, measured);
        return comparison;
    }

    private static FigureTable Programs(params (string Key, int[] Figures)[] rows)
    {
        FigureTable table = new CompiledTables("Mesa").Programs;
        foreach ((string key, int[] figures) in rows) table.Rows.Add(key, figures);
        return table;
    }

    private static FigureTable Loops(int cycles)
    {
        FigureTable table = new CompiledTables("Mesa").Loops;
        table.Rows.Add(Loop, [cycles, .. new int[12]]);
        return table;
    }

    private static int[] With(string column, int value)
    {
        int[] figures = [.. good];
        figures[Programs().IndexOf(column)] = value;
        return figures;
    }

}
