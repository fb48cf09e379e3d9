using Headless.Mutation;
using Headless.Tests.Player;
using NUnit.Framework;

namespace Headless.Tests.Mutation;

/// <summary>Three changes from end to end: map, change, tests, table.</summary>
public class CampaignTests
{
    [Test]
    public void ChangesOfAKernelAndOfCSharpAreCaughtByWhatCoversThem()
    {
        string project = Path.GetFullPath(Path.Combine(PlayerProcess.ProjectsFolder, "../../.."));
        string folder = Directory.CreateTempSubdirectory("mutation").FullName;
        const string kernel = "Packages/com.sphfluid/Thesis/Shaders/Solver/CalculateDensity.compute";
        string before = File.ReadAllText(Path.Combine(project, kernel));
        try
        {
            new Campaign(Options.Parse(
            [
                project, "--work", Path.Combine(folder, "work"), "--out", folder, "--shaders", "2", "--scripts", "1",
                "--files", "CalculateDensity.compute|WendlandKernel.cs", "--map-filter", "CalculateDensityTests.AgreesWithDoublePrecision(257);WendlandKernelTests",
            ])).Run();
            List<Row> rows = Table.Read(Path.Combine(folder, "mutants.csv"));
            rows.RemoveAll(r => r.IsDropped);
            Assert.That(rows, Has.Count.EqualTo(3));
            Assert.That(rows.Where(r => r.Mutant.File.EndsWith(".compute", StringComparison.Ordinal)).Select(r => r.Covering), Is.All.EqualTo(1));
            Assert.That(rows.Count(r => r.Verdict == Row.Caught), Is.GreaterThanOrEqualTo(2), string.Join('\n', rows));
            Assert.That(File.ReadAllText(Path.Combine(project, kernel)), Is.EqualTo(before), "the project itself is never written to");
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }
}
