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
        HashSet<string> components = [.. TypeReferences.Derived(Assembly, "MonoBehaviour", "ScriptableObject").Where(t => t != ShaderSet)];
        Assert.That(components, Is.SupersetOf(new[] { "FluidSimulation", "FluidVolume", "FluidProfile", "FluidSurfaceRenderer" }));
        HashSet<string> inside = [.. components, .. BesideComponents()];
        string[] outside = [.. uses.Where(u => !inside.Contains(u.Key) && u.Value.Overlaps(components))
            .Select(u => $"{u.Key}: {string.Join(", ", u.Value.Where(components.Contains).Order())}").Order()];
        string report = string.Join(Environment.NewLine, outside);
        TestContext.Out.WriteLine(report);
        Assert.That(outside, Is.Empty, report);
    }

    // Of the runtime's folders each names what is before it, and nothing after it.
    private static readonly string[] Folders =
    [
        "Foundation", "Saving", "Gpu", "Settings", "Collision", "Solver", "Surface", "Rendering", "Whitewater", "Zones", "Emission", "Spawning",
        "Queries", "Sensing", "Diagnostics", "Simulation", "Components",
    ];

    [Test]
    public void EachFolderNamesOnlyFoldersBeforeIt()
    {
        string[] present = [.. Directory.GetDirectories(Runtime).Where(d => Directory.EnumerateFiles(d, "*.cs", SearchOption.AllDirectories).Any()).Select(d => Path.GetFileName(d))];
        Assert.That(present, Is.EquivalentTo(Folders), "the order names every folder");
        Dictionary<string, int> folderOf = [];
        for (int i = 0; i < Folders.Length; i++)
        {
            foreach (string type in DeclaredIn(Folders[i])) folderOf[type] = i;
        }

        IReadOnlyDictionary<string, HashSet<string>> uses = TypeReferences.Read(Assembly).Uses;
        string[] unknown = [.. uses.Keys.Where(t => t.All(c => char.IsLetterOrDigit(c) || c == '_') && !folderOf.ContainsKey(t))];
        Assert.That(unknown, Is.Empty, "types whose folder was not found");
        string[] against = [.. from user in uses.Where(u => folderOf.ContainsKey(Plain(u.Key)))
                               from used in user.Value.Where(t => folderOf.ContainsKey(Plain(t)))
                               where folderOf[Plain(used)] > folderOf[Plain(user.Key)]
                               select $"{Folders[folderOf[Plain(user.Key)]]}/{user.Key} names {Folders[folderOf[Plain(used)]]}/{used}"];
        Assert.That(against, Is.Empty, string.Join(Environment.NewLine, against));
    }

    // A folder below Solver for each method.
    private static readonly string[] Methods = ["Standard", "Robust"];

    // What brings a liquid to rest by one.
    private static readonly string[] NamedOutsideTheirMethod = ["StartRelaxer"];

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

    [TestCase("Runtime/SphFluid.asmdef")]
    [TestCase("Editor/SphFluid.Editor.asmdef")]
    [TestCase("Universal/SphFluid.Universal.asmdef")]
    public void TheProductDoesWithoutTheThesisMethod(string assembly)
    {
        string package = Path.GetDirectoryName(Runtime)!;
        Assert.That(Path.Combine(package, "Thesis", "Runtime", "SphFluid.Thesis.asmdef"), Does.Exist);
        Assert.That(File.ReadAllText(Path.Combine(package, assembly)), Does.Contain("\"name\"").And.Not.Contains("Thesis"));
    }

    [Test]
    public void OfTheValidationPackageOneAssemblySeesMoreThanAnyone()
    {
        string[] friends = [.. Directory.GetFiles(Runtime, "*.cs", SearchOption.AllDirectories).SelectMany(File.ReadLines)
            .Where(line => line.Contains("InternalsVisibleTo(", StringComparison.Ordinal))];
        Assert.That(friends, Has.Some.Contains("\"SphFluid.Editor\""));
        Assert.That(friends.Where(f => f.Contains("Validation")), Is.EqualTo(new[] { "[assembly: InternalsVisibleTo(\"SphFluid.Validation.Laboratory\")]" }));
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

    // Generic types are compiled as Name`1.
    private static string Plain(string type) => type.Split('`')[0];

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

    [GeneratedRegex(@"^    (?:\w+ )*(?:class|struct|interface|enum|delegate [\w<>?]+) (\w+)", RegexOptions.Multiline)]
    private static partial Regex Declaration();
}
