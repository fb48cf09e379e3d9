using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

namespace Headless.Checks.Api;

/// <summary>Holds the public surface of the player's stand-in assemblies against the API lists: all of it must exist
/// in both Unity lines, so that code which compiles here compiles there.</summary>
internal sealed class StandInSurfaceCheck(string assemblyFolder)
{
    private static readonly string[] assemblies = ["UnityEngine", "UnityEditor", "UnityEngine.TestRunner", "UnityEditor.TestRunner", "Unity.Burst", "Unity.Mathematics"];

    public CheckReport Run()
    {
        var report = new CheckReport("stand-in surface");
        var files = assemblies.Select(a => Path.Combine(assemblyFolder, a + ".dll")).Where(File.Exists).ToList();
        if (files.Count == 0)
        {
            report.Findings.Add($"no stand-in assemblies in '{assemblyFolder}': build the player first");
            return report;
        }
        var lists = UnityLine.All.Take(2).Select(l => new ListedApi(ApiList.Load(l))).ToList();
        var references = Directory.GetFiles(assemblyFolder, "*.dll").Concat(Directory.GetFiles(Path.GetDirectoryName(typeof(object).Assembly.Location)!, "*.dll"))
            .Select(f => (MetadataReference)MetadataReference.CreateFromFile(f)).ToList();
        var compilation = CSharpCompilation.Create("surface", references: references);
        var members = 0;
        foreach (var symbol in compilation.References.Select(compilation.GetAssemblyOrModuleSymbol).OfType<IAssemblySymbol>().Where(a => assemblies.Contains(a.Name)))
            members += CheckNamespace(symbol.GlobalNamespace, lists, report);
        report.Figures = $"{members} public members of {files.Count} assemblies, all in both lists";
        return report;
    }

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
