using Headless.Bench.Model;
using Headless.Measure.Children;
using Headless.Measure.Parts;
using Headless.Measure.Results;
using NUnit.Framework;

namespace Headless.Tests.Measure;

/// <summary>What is read of the files that the parts leave.</summary>
public sealed class ResultTests
{
    private string folder = "";

    [SetUp]
    public void MakeFolder() => folder = Directory.CreateTempSubdirectory("measure").FullName;

    [TearDown]
    public void Delete() => Directory.Delete(folder, recursive: true);

    [Test]
    public void CellsWithCommasAndLinesThatWereCutOffAreRead()
    {
        string file = Write("a.csv", "table,device,ms\nsolver,\"llvmpipe (LLVM 15, \"\"256\"\" bits)\",2.5\nsolver,\"llv");
        CsvTable table = CsvTable.Read(file);

        Assert.That(table.Rows, Has.Count.EqualTo(1));
        Assert.That(table.Text(table.Rows[0], "device"), Is.EqualTo("llvmpipe (LLVM 15, \"256\" bits)"));
        Assert.That(table.Number(table.Rows[0], "ms"), Is.EqualTo(2.5));
    }

    [Test]
    public void TheModelsOwnTableIsUnderstood()
    {
        var words = new StringWriter();
        TextWriter before = Console.Out;
        Console.SetOut(words);
        try
        {
            ModelCommand.Run(Path.GetFullPath(Path.Combine(Player.PlayerProcess.ProjectsFolder, "../../..")), []);
        }
        finally
        {
            Console.SetOut(before);
        }
        IReadOnlyList<Estimates.Step> steps = Estimates.Read(Write("model.txt", words.ToString()));

        // Four kinds of steps for each card, and two of them for both supports.
        Assert.That(steps.Select(s => s.Config).Distinct().Count(), Is.EqualTo(6));
        Assert.That(steps, Has.Count.EqualTo(6 * steps.Select(s => s.Gpu).Distinct().Count()));
        Assert.That(steps.Select(s => s.Gpu), Has.Member("H200").And.Member("RTX 4070"));
        Assert.That(steps.All(s => s.Microseconds[0] > 0 && s.Microseconds[1] > s.Microseconds[0] && s.Microseconds[2] > s.Microseconds[1]));
    }

    [Test]
    public void TheFirstStepThatDiffersIsNamedWithItsLargestDistance()
    {
        for (int state = 0; state < 4; state++)
        {
            WriteState("own", state, 1f);
            WriteState("other", state, state < 2 ? 1f : 1.5f);
        }
        StateComparison found = StateComparison.Of(Path.Combine(folder, "own"), Path.Combine(folder, "other"));

        Assert.That(found, Is.EqualTo(new StateComparison(4, 2, 1, 2, 0.5)));
        Assert.That(found.ToString(), Does.Contain("step 2: 1 of 2 particles"));
    }

    [Test]
    public void EqualStatesAndNoneAreSaid()
    {
        WriteState("own", 0, 1f);
        WriteState("other", 0, 1f);

        Assert.That(StateComparison.Of(Path.Combine(folder, "own"), Path.Combine(folder, "other")).IsEqual);
        Assert.That(StateComparison.Of(Path.Combine(folder, "own"), Path.Combine(folder, "none")).ToString(), Does.StartWith("none is there"));
    }

    [Test]
    public void TestsThatDidNotEndAreNamedWithWhatFailed()
    {
        var ended = new ChildResult(ChildEnding.Failed, 1, []);
        PartOutcome sum = TestsPart.Sum(
        [
            new("A", ended, ["  pass  SphFluid.Tests.ATests.One (3 ms)", "  FAIL  SphFluid.Tests.ATests.Two (4 ms)", "1 passed, 1 failed, 0 skipped"]),
            new("B", new ChildResult(ChildEnding.Crashed, 139, ["Segmentation fault"]), ["  pass  SphFluid.Tests.BTests.One (3 ms)"]),
            new("C", ended, ["0 passed, 0 failed, 0 skipped"]),
        ]);

        Assert.That(sum.Ending, Is.EqualTo(ChildEnding.Crashed));
        Assert.That(sum.Lines[0], Is.EqualTo("2 passed, 1 failed, 0 skipped"));
        Assert.That(string.Join('\n', sum.Lines), Does.Contain("ATests.Two").And.Contain("not finished: the classes of B").And.Contain("Segmentation fault"));
    }

    private string Write(string name, string text)
    {
        string file = Path.Combine(folder, name);
        File.WriteAllText(file, text);
        return file;
    }

    // Two particles, of which one has the place given.
    private void WriteState(string run, int state, float x)
    {
        Directory.CreateDirectory(Path.Combine(folder, run));
        using var writer = new BinaryWriter(File.Create(Path.Combine(folder, run, $"frame-{state:00000}.ply")));
        writer.Write("ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n"u8);
        foreach (float value in new[] { x, 0, 0, 2, 3, 4 }) writer.Write(value);
    }
}
