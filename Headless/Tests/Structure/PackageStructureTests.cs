using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Headless.Tests.Structure;

/// <summary>How the compiled types of the product refer to each other.</summary>
public sealed partial class PackageStructureTests
{
    // This figure may only fall.
    private const int LargestCircle = 5;

    // An asset that the package ships and the solver's public constructor takes; it is data, not a component.
    private const string ShaderSet = "FluidShaderSet";

    private static string Root => Conformance.ReleaseBuildTests.FindUp("Headless/Play.slnx");

    private static string Runtime => Path.Combine(Root, "Packages", "com.sphfluid", "Runtime");

    private static string Assembly
    {
        get
        {
            string path = Path.Combine(Root, "Build", "ScriptAssemblies", "SphFluid.dll");
            Assume.That(File.Exists(path), $"'{path}' is missing: ./run build makes it");
            return path;
        }
    }

    [Test]
    public void CirclesOfReferencesAreFound()
    {
        Dictionary<string, HashSet<string>> uses = new()
        {
            ["A"] = ["B"], ["B"] = ["C", "D"], ["C"] = ["A"], ["D"] = ["E"], ["E"] = ["D", "F"], ["F"] = [],
        };
        Assert.That(TypeCircles.Find(uses), Is.EqualTo(new[] { new[] { "A", "B", "C" }, ["D", "E"] }));
    }

    [Test]
    public void ReferencesAreFoundInBasesFieldsAttributesAndCode()
    {
        IReadOnlyDictionary<string, HashSet<string>> uses = TypeReferences.Read(Assembly).Uses;
        Assert.That(uses["FluidSurfaceRenderer"], Contains.Item("FluidRenderer"), "base");
        Assert.That(uses["FluidVolume"], Contains.Item("FluidSimulation"), "field");
        Assert.That(uses["FluidDiagnostics"], Contains.Item("FluidMessage"), "code");
        Assert.That(uses["AffineMath"], Is.Empty);
    }

    [Test]
    public void NoCircleOfTypesIsLargerThanFive()
    {
        IReadOnlyList<IReadOnlyList<string>> circles = TypeCircles.Find(TypeReferences.Read(Assembly).Uses);
        string report = string.Join(Environment.NewLine, circles.Select(c => $"{c.Count}: {string.Join(", ", c)}"));
        TestContext.Out.WriteLine(report);
        Assert.That(circles.Count > 0 ? circles[0].Count : 0, Is.LessThanOrEqualTo(LargestCircle), report);
    }

    [Test]
    public void NothingOutsideTheComponentsNamesOne()
    {
        IReadOnlyDictionary<string, HashSet<string>> uses = TypeReferences.Read(Assembly).Uses;
        HashSet<string> components = [.. TypeReferences.Derived(Assembly, "MonoBehaviour", "ScriptableObject", "PlayableAsset").Where(t => t != ShaderSet)];
        Assert.That(components, Is.SupersetOf(new[] { "FluidSimulation", "FluidVolume", "FluidProfile", "FluidSurfaceRenderer" }));
        HashSet<string> inside = [.. components, .. BesideComponents()];
        string[] outside = [.. uses.Where(u => !inside.Contains(u.Key) && u.Value.Overlaps(components))
            .Select(u => $"{u.Key}: {string.Join(", ", u.Value.Where(components.Contains).Order())}").Order()];
        string report = string.Join(Environment.NewLine, outside);
        TestContext.Out.WriteLine(report);
        Assert.That(outside, Is.Empty, report);
    }

    // A folder below Solver for each method.
    private static readonly string[] Methods = ["Standard", "Robust", "Thesis"];

    // What users set of a method, and what brings a liquid to rest by one.
    private static readonly string[] NamedOutsideTheirMethod = ["ThesisSwitches", "StartRelaxer"];

    [Test]
    public void OnlyTheListOfMethodsNamesWhatIsInAMethodsFolder()
    {
        IReadOnlyDictionary<string, HashSet<string>> uses = TypeReferences.Read(Assembly).Uses;
        foreach (string method in Methods)
        {
            HashSet<string> own = [.. DeclaredIn(Path.Combine("Solver", method))];
            Assert.That(own, Contains.Item(method + "Method"));
            string[] users = [.. uses.Where(u => !own.Contains(u.Key) && u.Value.Any(t => own.Contains(t) && !NamedOutsideTheirMethod.Contains(t))).Select(u => u.Key)];
            Assert.That(users, Is.EqualTo(new[] { "FluidMethods" }), method);
        }
    }

    [Test]
    public void TheValidationPackageSeesWhatAnyoneSees()
    {
        string[] friends = [.. Directory.GetFiles(Runtime, "*.cs", SearchOption.AllDirectories).SelectMany(File.ReadLines)
            .Where(line => line.Contains("InternalsVisibleTo(", StringComparison.Ordinal))];
        Assert.That(friends, Has.Some.Contains("\"SphFluid.Editor\""));
        Assert.That(friends, Has.None.Contains("Validation"));
    }

    [Test]
    public void NothingOfTheProductUsesTheLaboratory()
    {
        IReadOnlyDictionary<string, HashSet<string>> uses = TypeReferences.Read(Assembly).Uses;
        HashSet<string> laboratory = [.. DeclaredIn("Laboratory")];
        Assert.That(laboratory, Contains.Item("SolverLaboratory"));
        Assert.That(uses.Where(u => !laboratory.Contains(u.Key) && u.Value.Overlaps(laboratory)).Select(u => u.Key), Is.Empty);
    }

    [Test]
    public void NothingOutsideAMethodsFolderAsksWhichMethodItIs()
    {
        string package = Path.GetDirectoryName(Runtime)!;
        string[] branches = [.. new[] { "Runtime", "Editor", "Universal" }.SelectMany(f => Directory.GetFiles(Path.Combine(package, f), "*.cs", SearchOption.AllDirectories))
            .Where(f => Methods.All(method => !f.Contains(Path.Combine("Solver", method))))
            .SelectMany(f => Branch().Matches(File.ReadAllText(f)).Select(m => $"{Path.GetFileName(f)}: {m.Value}"))];
        Assert.That(branches, Is.Empty);
    }

    // Types that the files of the components' folder declare.
    private static IEnumerable<string> BesideComponents() => DeclaredIn("Components");

    private static IEnumerable<string> DeclaredIn(string folder)
    {
        string path = Path.Combine(Runtime, folder);
        return !Directory.Exists(path) ? [] : Directory.GetFiles(path, "*.cs", SearchOption.AllDirectories)
            .SelectMany(f => Declaration().Matches(File.ReadAllText(f)).Select(m => m.Groups[1].Value));
    }

    // Automatic is no method.
    [GeneratedRegex(@"[!=]= FluidMethodKind\.(?!Automatic)\w+|is (?:not )?FluidMethodKind\.(?!Automatic)\w+|case FluidMethodKind\.\w+|FluidMethodKind\.\w+ =>")]
    private static partial Regex Branch();

    [GeneratedRegex(@"^    (?:\w+ )+(?:class|struct|interface|enum) (\w+)", RegexOptions.Multiline)]
    private static partial Regex Declaration();
}
