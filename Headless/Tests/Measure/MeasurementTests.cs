using Headless.Measure;
using Headless.Measure.Children;
using Headless.Measure.Parts;
using Headless.Measure.Results;
using NUnit.Framework;

namespace Headless.Tests.Measure;

/// <summary>The whole with parts that are made up: what fails is named, and what the others found stays.</summary>
public sealed class MeasurementTests
{
    private string folder = "";

    private string Out => Path.Combine(folder, "out");

    [SetUp]
    public void MakeFolder() => folder = Directory.CreateTempSubdirectory("measure").FullName;

    [TearDown]
    public void Delete() => Directory.Delete(folder, recursive: true);

    [Test]
    public void EachFailureIsNamedAndTheOthersResultsStay()
    {
        Part[] parts = [Good("one"), Failing("two"), Good("three"), Failing("four"), Good("five")];
        int code = Run(parts, new() { ["two"] = "crash", ["four"] = "memory" });

        CsvTable table = CsvTable.Read(Path.Combine(Out, ResultFolder.Parts));
        Assert.That(table.Rows.Select(row => table.Text(row, "ending")), Is.EqualTo(new[] { "done", "crashed", "done", "out of memory", "done" }));
        Assert.That(table.Text(table.Rows[3], "found"), Does.Contain("memory is full"));
        Assert.That(Directory.GetFiles(Out, "*.txt").Select(f => Path.GetFileName(f)), Is.SupersetOf(new[] { "one.txt", "three.txt", "five.txt" }));
        Assert.That(File.ReadAllText(Path.Combine(Out, MeasurementPage.FileName)), Does.Contain("out of memory"));
        Assert.That(code, Is.EqualTo(1));
    }

    [Test]
    public void WithoutADeviceNothingFollows()
    {
        Run([Failing("device") with { IsNeeded = true }, Good("one")], new() { ["device"] = "memory" });

        CsvTable table = CsvTable.Read(Path.Combine(Out, ResultFolder.Parts));
        Assert.That(table.Text(table.Rows[1], "found"), Does.Contain("no device"));
    }

    [Test]
    public void APartThatNeedsMoreThanIsLeftIsLeftOut()
    {
        Assert.That(Run([Good("one") with { Least = 1e6 }, Good("two")], []), Is.Zero);

        CsvTable table = CsvTable.Read(Path.Combine(Out, ResultFolder.Parts));
        Assert.That(table.Rows.Select(row => table.Text(row, "ending")), Is.EqualTo(new[] { "left out", "done" }));
        Assert.That(table.Text(table.Rows[0], "found"), Does.Contain("--minutes"));
    }

    [Test]
    public void AFolderWithOtherFilesIsRefused()
    {
        Directory.CreateDirectory(Out);
        File.WriteAllText(Path.Combine(Out, "thesis.docx"), "years of work");

        Assert.That(() => Run([Good("one")], []), Throws.TypeOf<UsageException>());
        Assert.That(File.Exists(Path.Combine(Out, "thesis.docx")));
    }

    [Test]
    public void AnEarlierMeasurementIsReplaced()
    {
        Run([Good("one")], []);
        Assert.That(Run([Good("two")], []), Is.Zero);
        Assert.That(File.Exists(Path.Combine(Out, "one.txt")), Is.False);
    }

    [TestCase("solver,scene", new[] { "device", "solver", "scene" })]
    [TestCase("tests", new[] { "device", "tests" })]
    public void PartsAreThoseThatAreNamedBehindTheDevice(string list, string[] names) =>
        Assert.That(AllParts.Of(list).Select(p => p.Name), Is.EqualTo(names));

    [Test]
    public void AnUnknownPartIsNamedWithTheNearest() =>
        Assert.That(() => AllParts.Of("solvr"), Throws.TypeOf<UsageException>().With.Message.Contains("solver"));

    [Test]
    public void EveryClassOfTestsHasOneShare()
    {
        foreach (string name in new[] { "SphFluid.Tests.ScanCellsTests.AllAreCounted(3)", "SphFluid.Tests.ScanCellsTests(1).Sums(2)", "SphFluid.Tests.Odd.Sums" })
        {
            int shares = TestsPart.Shares.Count(s => s.Filter.Split(';').All(term => !System.Text.RegularExpressions.Regex.IsMatch(
                name, term[1..], System.Text.RegularExpressions.RegexOptions.IgnoreCase)));
            Assert.That(shares, Is.EqualTo(1), name);
        }
    }

    private int Run(Part[] parts, Dictionary<string, string> faults) => new Measurement(new MeasureOptions
    {
        Place = new Workplace
        {
            Project = Path.GetFullPath(Path.Combine(Player.PlayerProcess.ProjectsFolder, "../../..")), Assemblies = "", Model = "", States = "", CommitFile = "",
            DefaultOut = "", Program = ("dotnet", [Path.Combine(AppContext.BaseDirectory, "sphmeasure.dll")]),
        },
        Parts = parts, Out = Out, Faults = faults,
    }).Run();

    private static Part Good(string name) => new(name, "is all well", 1, 0, run =>
    {
        File.WriteAllText(run.Results.In(name + ".txt"), "found");
        return new PartOutcome(ChildEnding.Done, ["found"]);
    });

    private static Part Failing(string name) => new(name, "is all well", 1, 0, run => PartOutcome.Of(run.Devices(), []));
}
