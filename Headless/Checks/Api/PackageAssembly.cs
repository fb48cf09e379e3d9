using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using System.Text.Json;

namespace Headless.Checks.Api;

/// <summary>An assembly definition of the package and its sources. An optional one is compiled only in projects with another package.</summary>
internal sealed record PackageAssembly(string Name, string Folder, IReadOnlyList<string> References, bool EditorOnly, bool IsTest, bool IsOptional, bool IsSample, IReadOnlyList<string> ModuleDefines, bool AllowsUnsafe = false)
{
    /// <summary>Those of a package, without its samples'.</summary>
    public static List<PackageAssembly> FindAll(string packageRoot) => Find(packageRoot, samples: false);

    /// <summary>Those of a package's samples, which the Editor compiles once they are copied into a project.</summary>
    public static List<PackageAssembly> FindSamples(string packageRoot) => Find(packageRoot, samples: true);

    private static List<PackageAssembly> Find(string packageRoot, bool samples)
    {
        var found = new List<PackageAssembly>();
        foreach (var file in Directory.GetFiles(packageRoot, "*.asmdef", SearchOption.AllDirectories).Order())
        {
            if (samples != Path.GetRelativePath(packageRoot, file).StartsWith("Samples~", StringComparison.Ordinal)) continue;
            using var json = JsonDocument.Parse(File.ReadAllText(file));
            var root = json.RootElement;
            found.Add(new PackageAssembly(
                root.GetProperty("name").GetString()!,
                Path.GetDirectoryName(file)!,
                root.GetProperty("references").EnumerateArray().Select(r => r.GetString()!).ToList(),
                root.GetProperty("includePlatforms").EnumerateArray().Any(p => p.GetString() == "Editor"),
                Constraints(root).Contains("UNITY_INCLUDE_TESTS"),
                Constraints(root).Intersect(VersionDefines(root, "")).Any(),
                samples,
                [.. VersionDefines(root, "com.unity.modules.")],
                root.TryGetProperty("allowUnsafeCode", out JsonElement allowed) && allowed.GetBoolean()));
        }
        return InDependencyOrder(found);
    }

    private static IEnumerable<string> Constraints(JsonElement root) => root.GetProperty("defineConstraints").EnumerateArray().Select(c => c.GetString()!);

    private static IEnumerable<string> VersionDefines(JsonElement root, string prefix) => !root.TryGetProperty("versionDefines", out JsonElement all) ? [] :
        all.EnumerateArray().Where(d => d.GetProperty("name").GetString()!.StartsWith(prefix, StringComparison.Ordinal)).Select(d => d.GetProperty("define").GetString()!);

    public IEnumerable<string> SourceFiles() =>
        Directory.GetFiles(Folder, "*.cs", SearchOption.AllDirectories).Where(f => !OwnedByNestedAssembly(f)).Order();

    private bool OwnedByNestedAssembly(string file)
    {
        for (var folder = Path.GetDirectoryName(file)!; folder.Length > Folder.Length; folder = Path.GetDirectoryName(folder)!)
            if (Directory.GetFiles(folder, "*.asmdef").Length > 0) return true;
        return false;
    }

    public List<SyntaxTree> Parse(IEnumerable<string> defines)
    {
        var options = new CSharpParseOptions(LanguageVersion.CSharp9, DocumentationMode.Diagnose, preprocessorSymbols: defines);
        return SourceFiles().Select(f => CSharpSyntaxTree.ParseText(File.ReadAllText(f), options, f)).ToList();
    }

    /// <summary>Those of every package, the product's first.</summary>
    public static List<PackageAssembly> FindAll(ProjectPackages packages) => [.. packages.All.SelectMany(FindAll)];

    private static List<PackageAssembly> InDependencyOrder(List<PackageAssembly> assemblies)
    {
        var ordered = new List<PackageAssembly>();
        void Visit(PackageAssembly a)
        {
            if (ordered.Contains(a)) return;
            foreach (var r in a.References)
                if (assemblies.FirstOrDefault(x => x.Name == r) is { } dependency) Visit(dependency);
            ordered.Add(a);
        }
        foreach (var a in assemblies) Visit(a);
        return ordered;
    }
}
