using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Headless.Checks.Api;

/// <summary>Compiles every assembly of the packages as C# 9 for .NET Standard 2.1 against the real public API of a
/// Unity line, as the Editor does and, for runtime assemblies, as a player build does. The product is compiled first and sees
/// nothing of the packages that build on it: a game that installs it alone compiles.</summary>
internal sealed class ApiCheck(ProjectPackages packages)
{
    private static readonly Dictionary<string, string[]> lineDefines = new()
    {
        ["2022.3"] = ["UNITY_2022_3", "UNITY_2022_3_OR_NEWER", "UNITY_2022_2_OR_NEWER", "UNITY_2022_1_OR_NEWER", "UNITY_2021_3_OR_NEWER", "UNITY_5_3_OR_NEWER"],
        ["6000.0"] = ["UNITY_6000", "UNITY_6000_0", "UNITY_6000_0_OR_NEWER", "UNITY_2023_1_OR_NEWER", "UNITY_2022_3_OR_NEWER", "UNITY_2022_2_OR_NEWER", "UNITY_2022_1_OR_NEWER", "UNITY_2021_3_OR_NEWER", "UNITY_5_3_OR_NEWER"],
    };

    // Unity ships NUnit 3.5; the oldest framework on NuGet is 3.6, which added these.
    private static readonly string[] laterNUnit = ["M:NUnit.Framework.Assert.Multiple", "M:NUnit.Framework.Assert.Warn", "T:NUnit.Framework.Warn", "M:NUnit.Framework.Warn."];

    /// <summary>Compiler messages about members that a Unity line marks obsolete.</summary>
    internal static readonly string[] Obsolete = ["CS0612", "CS0618", "CS0619", "CS0672"];

    // Serialised fields are assigned by the Editor.
    private static readonly string[] ignored = ["CS0649", "CS0414", "CS1701", "CS1702"];

    public IEnumerable<CheckReport> Run()
    {
        var editorOnly = ApiList.LoadEditorOnlyMembers();
        foreach (var line in ApiList.Lines)
        {
            var references = ReferenceAssemblies.Of(line);
            foreach (var editor in new[] { true, false })
            {
                var built = new Dictionary<string, CSharpCompilation>();
                foreach (var package in packages.All) yield return Compile(package, line, references, editor, editorOnly, built);
            }
            yield return Compile(packages.Product, line, references, editor: false, editorOnly, [], modules: false);
        }
    }

    /// <param name="built">Assemblies of the packages before this one; gets this one's.</param>
    /// <param name="modules">Whether the project has the modules of the engine that the package can do without: terrain.</param>
    private static CheckReport Compile(
        string package, string line, ReferenceAssemblies references, bool editor, IReadOnlySet<string> editorOnly, Dictionary<string, CSharpCompilation> built,
        bool modules = true)
    {
        var report = new CheckReport($"API {line} {(editor ? "Editor" : "player")}, {Path.GetFileName(package)}{(modules ? "" : " without modules")}");
        var used = new HashSet<string>();
        var before = built.Count;
        foreach (var assembly in PackageAssembly.FindAll(package))
        {
            if (!editor && (assembly.EditorOnly || assembly.IsTest)) continue;
            var compilation = CreateCompilation(assembly, line, references, editor, modules, built, report.Findings);
            built[assembly.Name] = compilation;
            foreach (var diagnostic in compilation.GetDiagnostics())
                if (IsFinding(diagnostic, assembly)) report.Findings.Add($"{assembly.Name}: {Describe(diagnostic)}");
            CollectUsedMembers(compilation, used, report.Findings, editorOnly, forPlayers: !assembly.EditorOnly && !assembly.IsTest);
        }
        if (!modules) report.Findings.AddRange(used.Where(id => id.Contains(":UnityEngine.Terrain")).Select(id => $"{id} needs a module that a project may not have"));
        report.Figures = $"{built.Count - before} {(built.Count - before == 1 ? "assembly compiles" : "assemblies compile")}, {used.Count} Unity members used, {references.MemberCount} known";
        return report;
    }

    /// <summary>What a script of a user's is compiled with in the Editor: Unity, NUnit and the packages' runtime assemblies that are referenced without asking.</summary>
    public static (IReadOnlyList<MetadataReference> References, CSharpParseOptions Options) ReferencesForUsers(ProjectPackages packages, string line)
    {
        var unity = ReferenceAssemblies.Of(line);
        var built = new Dictionary<string, CSharpCompilation>();
        foreach (var assembly in packages.All.SelectMany(PackageAssembly.FindAll).Where(a => !a.EditorOnly && !a.IsTest && !a.IsOptional))
            built[assembly.Name] = CreateCompilation(assembly, line, unity, editor: true, modules: true, built, []);
        return ([.. ReferenceAssemblies.NetStandard, unity.Engine, unity.Editor, unity.EngineTestRunner, ReferenceAssemblies.NUnit, .. unity.Packages.Values, .. built.Values.Select(b => b.ToMetadataReference())],
            new CSharpParseOptions(LanguageVersion.CSharp9, preprocessorSymbols: Defines(line, editor: true)));
    }

    private static List<string> Defines(string line, bool editor)
    {
        var defines = new List<string>(lineDefines[line]) { "UNITY_STANDALONE", "UNITY_STANDALONE_WIN", "NET_STANDARD_2_1", "NET_STANDARD", "ENABLE_MONO" };
        if (editor) defines.AddRange(["UNITY_EDITOR", "UNITY_EDITOR_WIN", "UNITY_INCLUDE_TESTS", "ENABLE_PROFILER"]);
        return defines;
    }

    private static CSharpCompilation CreateCompilation(PackageAssembly assembly, string line, ReferenceAssemblies references, bool editor, bool modules,
        Dictionary<string, CSharpCompilation> built, List<string> findings)
    {
        var defines = Defines(line, editor);
        if (modules) defines.AddRange(assembly.ModuleDefines);
        var metadata = new List<MetadataReference>(ReferenceAssemblies.NetStandard) { references.Engine };
        if (editor) metadata.Add(references.Editor);
        foreach (var name in assembly.References)
        {
            if (name == "UnityEngine.TestRunner") metadata.Add(references.EngineTestRunner);
            else if (name == "UnityEditor.TestRunner") metadata.Add(references.EditorTestRunner);
            else if (references.Packages.TryGetValue(name, out var package)) metadata.Add(package);
            else if (built.TryGetValue(name, out var dependency)) metadata.Add(dependency.ToMetadataReference());
            else findings.Add($"{assembly.Name}: references {name}, which is neither Unity's nor of a package that it may build on");
        }
        if (assembly.IsTest) metadata.Add(ReferenceAssemblies.NUnit);
        return CSharpCompilation.Create(assembly.Name, assembly.Parse(defines), metadata,
            new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary, warningLevel: 4, allowUnsafe: assembly.AllowsUnsafe));
    }

    private static bool IsFinding(Diagnostic diagnostic, PackageAssembly assembly)
    {
        if (diagnostic.Severity == DiagnosticSeverity.Error || Obsolete.Contains(diagnostic.Id)) return true;
        if (diagnostic.Severity != DiagnosticSeverity.Warning || ignored.Contains(diagnostic.Id)) return false;
        return !(assembly.IsTest && diagnostic.Id == "CS1591");
    }

    private static string Describe(Diagnostic diagnostic)
    {
        var span = diagnostic.Location.GetLineSpan();
        return $"{Path.GetFileName(span.Path)}({span.StartLinePosition.Line + 1}): {diagnostic.Id} {diagnostic.GetMessage()}";
    }

    private static void CollectUsedMembers(CSharpCompilation compilation, HashSet<string> used, List<string> findings, IReadOnlySet<string> editorOnly, bool forPlayers)
    {
        foreach (var tree in compilation.SyntaxTrees)
        {
            var model = compilation.GetSemanticModel(tree);
            foreach (var node in tree.GetRoot().DescendantNodes().OfType<SimpleNameSyntax>())
            {
                var symbol = model.GetSymbolInfo(node).Symbol;
                if (symbol is IMethodSymbol { ReducedFrom: { } original }) symbol = original;
                var assembly = symbol?.ContainingAssembly?.Name;
                if (assembly == "nunit.framework" && symbol!.OriginalDefinition.GetDocumentationCommentId() is { } nunit && laterNUnit.Any(nunit.StartsWith))
                    findings.Add($"{Place(compilation, tree, node)}: {nunit} is newer than Unity's NUnit 3.5");
                if (assembly is null || !assembly.StartsWith("Unity", StringComparison.Ordinal)) continue;
                var id = symbol!.OriginalDefinition.GetDocumentationCommentId();
                if (id is null) continue;
                used.Add(id);
                if (forPlayers && editorOnly.Contains(id))
                    findings.Add($"{Place(compilation, tree, node)}: {id} exists only in the Editor");
            }
        }
    }

    private static string Place(CSharpCompilation compilation, SyntaxTree tree, SyntaxNode node) =>
        $"{compilation.AssemblyName}: {Path.GetFileName(tree.FilePath)}({node.GetLocation().GetLineSpan().StartLinePosition.Line + 1})";
}
