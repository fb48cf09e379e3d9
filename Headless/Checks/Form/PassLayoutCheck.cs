using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Headless.Checks.Form;

/// <summary>
/// A pass, its kernels and its tests lie at mirrored paths: Runtime/A/XPass.cs with the class XPass,
/// Shaders/A/X.compute, which the pass names, and Tests/Editor/A/XTests.cs with tests. Every kernel file has a pass. A folder with a Runtime of its own, such as Thesis,
/// is laid out like a package.
/// </summary>
internal sealed class PassLayoutCheck(ProjectPackages packages)
{
    private const string Base = "ComputePass";
    private static readonly string[] testAttributes = ["Test", "TestCase", "TestCaseSource", "UnityTest"];

    public CheckReport Run()
    {
        var report = new CheckReport("passes, kernels and tests");
        var count = 0;
        foreach (var package in packages.All.SelectMany(Rooms))
        {
            var owned = new HashSet<string>();
            foreach (var (file, pass) in Passes(package))
            {
                count++;
                report.Findings.AddRange(Check(package, file, pass, owned));
            }
            foreach (var kernel in Files(package, "Shaders", "*.compute").Where(k => !owned.Contains(k)))
                report.Findings.Add($"{Shown(package, kernel)} has no pass: {Orphan(package, kernel)}");
        }
        report.Figures = $"passes with their kernels and tests: {count}";
        return report;
    }

    /// <summary>A package, and folders of it that are laid out like one: com.sphfluid and com.sphfluid/Thesis.</summary>
    private static IEnumerable<string> Rooms(string package) =>
        [package, .. Directory.GetDirectories(package).Where(d => Directory.Exists(Path.Combine(d, "Runtime"))).Order(StringComparer.Ordinal)];

    private IEnumerable<string> Check(string package, string file, TypeDeclarationSyntax pass, HashSet<string> owned)
    {
        var (name, shown) = (pass.Identifier.Text, Shown(package, file));
        if (!name.EndsWith("Pass", StringComparison.Ordinal))
        {
            yield return $"{shown}: {name} is a pass, so its name ends in Pass";
            yield break;
        }
        if (Path.GetFileName(file) != name + ".cs" || !file.StartsWith("Runtime/", StringComparison.Ordinal))
        {
            yield return $"{shown}: the pass {name} belongs in a file {name}.cs below Runtime";
            yield break;
        }

        var kernel = Moved(file, "Runtime", "Shaders", "Pass.cs", ".compute");
        owned.Add(kernel);
        if (Misplaced(package, kernel, "Shaders", "its kernels") is { } kernelFinding)
            yield return $"{shown}: {kernelFinding}";
        var shader = Path.GetFileNameWithoutExtension(kernel);
        if (NamedShader(pass) is { } named && named != shader)
            yield return $"{shown}: {name} names the shader '{named}', not '{shader}'";

        var tests = Moved(file, "Runtime", "Tests/Editor", "Pass.cs", "Tests.cs");
        if (Misplaced(package, tests, "Tests/Editor", "its tests") is { } testFinding)
            yield return $"{shown}: {testFinding}";
        else if (!HasTests(Path.Combine(package, tests), shader + "Tests"))
            yield return $"{Shown(package, tests)} has no class {shader}Tests with a test";
    }

    private static string Orphan(string package, string kernel)
    {
        var file = Moved(kernel, "Shaders", "Runtime", ".compute", "Pass.cs");
        return File.Exists(Path.Combine(package, file)) ? $"{file} declares no {Base}" : $"{file} is missing";
    }

    /// <summary>What is wrong with where a file should be; null for nothing.</summary>
    private static string? Misplaced(string package, string expected, string root, string what)
    {
        if (File.Exists(Path.Combine(package, expected))) return null;
        var name = Path.GetFileName(expected);
        var elsewhere = Files(package, root, name).FirstOrDefault();
        return elsewhere is null ? $"{what} are missing, {expected}" : $"{what} belong in {expected}, not {elsewhere}";
    }

    /// <summary>Classes that derive from the base of passes and are not abstract, each with its file.</summary>
    private static List<(string File, TypeDeclarationSyntax Type)> Passes(string package)
    {
        string[] rooms = [.. Rooms(package).Skip(1).Select(r => Path.GetFileName(r) + "/")];
        var types = Files(package, "", "*.cs")
            .Where(f => !f.StartsWith("Tests/", StringComparison.Ordinal) && !f.Contains('~') && !rooms.Any(f.StartsWith))
            .SelectMany(f => Types(Path.Combine(package, f)).Select(t => (File: f, Type: t))).ToList();
        var bases = new HashSet<string> { Base };
        var found = new List<(string File, TypeDeclarationSyntax Type)>();
        for (var before = -1; before != found.Count;)
        {
            before = found.Count;
            found = types.FindAll(t =>
                t.Type.BaseList?.Types.Any(b => bases.Contains(b.Type.ToString().Split('.')[^1])) == true);
            bases.UnionWith(found.Select(t => t.Type.Identifier.Text));
        }
        return found.FindAll(t => !t.Type.Modifiers.Any(SyntaxKind.AbstractKeyword));
    }

    private static IEnumerable<TypeDeclarationSyntax> Types(string file) =>
        CSharpSyntaxTree.ParseText(File.ReadAllText(file)).GetRoot().DescendantNodes().OfType<TypeDeclarationSyntax>();

    /// <summary>The literal that a pass hands to its base.</summary>
    private static string? NamedShader(TypeDeclarationSyntax pass) => pass.Members
        .OfType<ConstructorDeclarationSyntax>()
        .SelectMany(c => c.Initializer?.ArgumentList.Arguments ?? default)
        .Select(a => a.Expression).OfType<LiteralExpressionSyntax>()
        .FirstOrDefault(l => l.IsKind(SyntaxKind.StringLiteralExpression))?.Token.ValueText;

    private static bool HasTests(string file, string name) =>
        Types(file).FirstOrDefault(t => t.Identifier.Text == name) is { } tests &&
        tests.Members.OfType<MethodDeclarationSyntax>().Any(m => testAttributes.Any(a => m.AttributeLists.Has(a)));

    /// <summary>Paths below a package of its files of a pattern, in a folder of it.</summary>
    private static IEnumerable<string> Files(string package, string folder, string pattern)
    {
        var root = Path.Combine(package, folder);
        if (!Directory.Exists(root)) return [];
        return Directory.GetFiles(root, pattern, SearchOption.AllDirectories)
            .Select(f => Path.GetRelativePath(package, f).Replace('\\', '/')).Order(StringComparer.Ordinal);
    }

    /// <example>Runtime/A/XPass.cs, from Runtime to Shaders, from Pass.cs to .compute: Shaders/A/X.compute</example>
    private static string Moved(string file, string root, string toRoot, string end, string toEnd) =>
        toRoot + file[root.Length..^end.Length] + toEnd;

    private string Shown(string package, string file) => packages.NameOf(Path.Combine(package, file));
}
