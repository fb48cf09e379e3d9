using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

namespace Headless.Checks.Api;

/// <summary>
/// Holds the public surface of the player's stand-in assemblies against the API lists: all of it must exist in the two oldest Unity lines, so
/// that code which compiles here compiles there. That of the render pipelines, which each line changes, is 6000.0's alone: the one that
/// has both the render graph and what came before it.
/// </summary>
internal sealed class StandInSurfaceCheck(string assemblyFolder)
{
    private static readonly string[] assemblies = ["UnityEngine", "UnityEditor", "UnityEngine.TestRunner", "UnityEditor.TestRunner", "Unity.Burst", "Unity.Mathematics"];

    private static readonly string[] pipelines = ["Unity.RenderPipelines.Core.Runtime", "Unity.RenderPipelines.Universal.Runtime"];

    private const string OfPipelines = "6000.0";

    private static readonly string[] others = ["2022.3", "6000.5"];

    public CheckReport Run()
    {
        var report = new CheckReport("stand-in surface");
        var files = assemblies.Concat(pipelines).Select(a => Path.Combine(assemblyFolder, a + ".dll")).Where(File.Exists).ToList();
        if (files.Count == 0)
        {
            report.Findings.Add($"no stand-in assemblies in '{assemblyFolder}': build the player first");
            return report;
        }
        var lists = UnityLine.All.Take(2).Select(l => new ListedApi(ApiList.Load(l))).ToList();
        List<ListedApi> ofPipelines = [Listed(OfPipelines)];
        var references = Directory.GetFiles(assemblyFolder, "*.dll").Concat(Directory.GetFiles(Path.GetDirectoryName(typeof(object).Assembly.Location)!, "*.dll"))
            .Select(f => (MetadataReference)MetadataReference.CreateFromFile(f)).ToList();
        var compilation = CSharpCompilation.Create("surface", references: references);
        var found = compilation.References.Select(compilation.GetAssemblyOrModuleSymbol).OfType<IAssemblySymbol>().ToList();
        var members = Count(assemblies, lists, report);
        var scriptable = Count(pipelines, ofPipelines, report);
        var elsewhere = others.Select(l => $"{Count(pipelines, [Listed(l)], null)} in {l}");
        report.Figures = $"{members} public members of {assemblies.Length} assemblies, all in both lists; {scriptable} of the render pipelines in {OfPipelines}, of which {string.Join(", ", elsewhere)}";
        return report;

        int Count(string[] names, List<ListedApi> listed, CheckReport? into)
        {
            var missing = into ?? new CheckReport("");
            var before = missing.Findings.Count;
            var all = found.Where(a => names.Contains(a.Name)).Sum(a => CheckNamespace(a.GlobalNamespace, listed, missing));
            return into is null ? all - (missing.Findings.Count - before) : all;
        }
    }

    private static ListedApi Listed(string line) => new(ApiList.Load(UnityLine.All.First(l => l.Name == line)));

    private static int CheckNamespace(INamespaceSymbol ns, List<ListedApi> lists, CheckReport report) =>
        ns.GetTypeMembers().Sum(t => CheckType(t, lists, report)) + ns.GetNamespaceMembers().Sum(n => CheckNamespace(n, lists, report));

    private static int CheckType(INamedTypeSymbol type, List<ListedApi> lists, CheckReport report)
    {
        if (!IsVisible(type)) return 0;
        var checkedMembers = 1;
        if (!Require(type, type, lists, report)) return 1;
        foreach (var member in type.GetMembers())
        {
            if (member is INamedTypeSymbol nested) { checkedMembers += CheckType(nested, lists, report); continue; }
            if (!IsVisible(member) || member.IsImplicitlyDeclared || IsUnlistedByNature(member)) continue;
            checkedMembers++;
            Require(member, type, lists, report);
        }
        return checkedMembers;
    }

    private static bool Require(ISymbol symbol, INamedTypeSymbol type, List<ListedApi> lists, CheckReport report)
    {
        foreach (var list in lists)
            if (!list.Contains(symbol, type))
            {
                report.Findings.Add($"{symbol.GetDocumentationCommentId()} is not in Unity {list.Line}");
                return false;
            }
        return true;
    }

    private static bool IsVisible(ISymbol symbol) =>
        symbol.DeclaredAccessibility is Accessibility.Public or Accessibility.Protected or Accessibility.ProtectedOrInternal;

    private static bool IsUnlistedByNature(ISymbol member) => member switch
    {
        IMethodSymbol { MethodKind: MethodKind.PropertyGet or MethodKind.PropertySet or MethodKind.EventAdd or MethodKind.EventRemove or MethodKind.StaticConstructor or MethodKind.Destructor or MethodKind.ExplicitInterfaceImplementation or MethodKind.DelegateInvoke } => true,
        IMethodSymbol { MethodKind: MethodKind.Constructor, Parameters.Length: 0 } => true,
        IMethodSymbol { ContainingType.TypeKind: TypeKind.Delegate } => true,
        IFieldSymbol { Name: "value__" } => true,
        _ => false,
    };
}
