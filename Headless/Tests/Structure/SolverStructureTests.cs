using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Headless.Tests.Structure;

/// <summary>How much of the solver has to be read for one kernel, and in how many places a force is named.</summary>
public sealed partial class SolverStructureTests
{
    private static string Package => Path.Combine(Conformance.ReleaseBuildTests.FindUp("Headless/Play.slnx"), "Packages", "com.sphfluid");

    private static string Shaders => Path.Combine(Package, "Shaders");

    // What the list of forces alone cannot say: the user's fields, the rules' input, a feature and a limit of the step that users read.
    private static readonly string[] NameSurfaceTension =
        ["FluidMethodFeatures.cs", "FluidProfile.cs", "FluidRuleInput.cs", "GradientCorrectionForce.cs", "StandardForces.cs", "TimeStepAdvice.cs"];

    // These figures may only fall. The gradient correction, four files of 300 lines, works in the pass that goes through the pairs. Lists of
    // 16 bits a neighbour took 80 lines to read, and a file of 95 to write; pairs of particles without a list 13 to 19. A table of the
    // cells with particles took a file of 60 lines to read, and 36 lines that ask which table it is and where its numbers stand.
    [TestCase("Solver/Standard/StandardDensity.compute", 16, 1340)]
    [TestCase("Solver/Standard/MoveParticles.compute", 30, 2242)]
    public void AKernelIsReadInFewFilesAndLines(string kernel, int mostFiles, int mostLines)
    {
        var files = new HashSet<string>();
        Include(Path.Combine(Shaders, kernel), files);
        int lines = files.Sum(f => File.ReadLines(f).Count());
        TestContext.Out.WriteLine($"{files.Count} files, {lines} lines: {string.Join(", ", files.Select(Path.GetFileName))}");
        Assert.That(files, Has.Count.GreaterThan(5), "includes are followed");
        Assert.That(files.Count, Is.LessThanOrEqualTo(mostFiles));
        Assert.That(lines, Is.LessThanOrEqualTo(mostLines));
    }

    [Test]
    public void OnlyTheListOfForcesNamesTheTypesOfOne()
    {
        string folder = Path.Combine(Package, "Runtime", "Solver", "Standard", "Tension");
        string assembly = Path.Combine(Package, "..", "..", "Build", "ScriptAssemblies", "SphFluid.dll");
        Assume.That(File.Exists(assembly), $"'{assembly}' is missing: ./run build makes it");
        HashSet<string> own = [.. Directory.GetFiles(folder, "*.cs").SelectMany(f => Declaration().Matches(File.ReadAllText(f)).Select(m => m.Groups[1].Value))];
        Assert.That(own, Is.SupersetOf(new[] { "SurfaceTensionForce", "SurfaceTensionPass", "TensionBuffers", "CapillaryRules" }));
        string[] users = [.. TypeReferences.Read(assembly).Uses.Where(u => !own.Contains(u.Key) && u.Value.Overlaps(own)).Select(u => u.Key)];
        Assert.That(users, Is.EqualTo(new[] { "StandardForces" }));
    }

    [Test]
    public void FewFilesNameSurfaceTensionOutsideItsFolder()
    {
        string runtime = Path.Combine(Package, "Runtime");
        string[] files = [.. Directory.GetFiles(runtime, "*.cs", SearchOption.AllDirectories)
            .Where(f => !f.Contains(Path.Combine("Standard", "Tension")))
            .Where(f => Tension().IsMatch(File.ReadAllText(f))).Select(f => Path.GetFileName(f)).Order(StringComparer.Ordinal)];
        Assert.That(files, Is.EqualTo(NameSurfaceTension));
    }

    private static void Include(string file, HashSet<string> files)
    {
        if (!files.Add(Path.GetFullPath(file))) return;
        foreach (Match include in Included().Matches(File.ReadAllText(file)))
        {
            Include(Path.Combine(Path.GetDirectoryName(file)!, include.Groups[1].Value), files);
        }
    }

    [GeneratedRegex("""^\s*#include\s+"([^"]+)"\s*$""", RegexOptions.Multiline)]
    private static partial Regex Included();

    [GeneratedRegex("(?<![a-z])[Tt]ension|[Ss]urfaceTension|Capillar")]
    private static partial Regex Tension();

    [GeneratedRegex(@"^    (?:internal|public) (?:\w+ )*(?<!partial )(?:class|struct|interface|enum) (\w+)", RegexOptions.Multiline)]
    private static partial Regex Declaration();
}
