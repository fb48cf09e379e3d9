using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using System.Reflection;

namespace Headless.Checks.Api;

/// <summary>Signature-only assemblies of one Unity line, made from its API lists, with what a source can see of them.</summary>
internal sealed class ReferenceAssemblies
{
    /// <summary>
    /// What the compiler's messages about an entry begin with that not every pass has. Then come the hexadecimal sum of the lines where it
    /// differs, E where only the Editor has it, and M where a project may lack its module.
    /// </summary>
    public const string Marked = "SPH";

    // Of the engine's modules, those that a project may have or not and that the packages ask for by defines.
    private static readonly string[] optionalModules = ["Terrain", "TerrainPhysics", "Vehicles"];

    private static readonly IReadOnlySet<string> editorOnlyMembers = ApiList.LoadEditorOnlyMembers();

    public MetadataReference Engine { get; }
    public MetadataReference Editor { get; }
    public MetadataReference EngineTestRunner { get; }
    public MetadataReference EditorTestRunner { get; }

    /// <summary>Assemblies that an assembly definition may name, which may be modules of the engine.</summary>
    public IReadOnlyDictionary<string, MetadataReference> Packages { get; }

    /// <summary>Members of the lists.</summary>
    public int MemberCount { get; }

    public static IReadOnlyList<MetadataReference> NetStandard { get; } =
        Directory.GetFiles(Metadata("NetStandardReferences"), "*.dll").Select(f => (MetadataReference)MetadataReference.CreateFromFile(f)).ToList();

    public static MetadataReference NUnit { get; } = MetadataReference.CreateFromFile(Metadata("NUnitFramework"));

    /// <summary>Types of all of them, nested ones too.</summary>
    public IReadOnlyList<ApiTypeNode> Types { get; }

    private readonly IReadOnlyList<ApiDifference> differences;

    /// <param name="line">The line.</param>
    /// <param name="words">Words of the source that is compiled against it.</param>
    /// <param name="differ">From the types, differences to other lines, whose uses are marked.</param>
    public ReferenceAssemblies(UnityLine line, IReadOnlySet<string> words, Func<IReadOnlyList<ApiTypeNode>, IReadOnlyList<ApiDifference>>? differ = null)
    {
        var list = ApiList.Load(line);
        MemberCount = list.All.Count();
        var engine = ApiTypeNode.Build(list.Engine);
        var editor = ApiTypeNode.Build(list.Editor);
        var packages = list.Packages.Select(p => (p.Key, Types: ApiTypeNode.Build(p.Value))).ToList();
        var runner = ApiTypeNode.Build(list.TestFramework.Where(e => e.Module == "UnityEngine.TestRunner"));
        var editorRunner = ApiTypeNode.Build(list.TestFramework.Where(e => e.Module == "UnityEditor.TestRunner"));
        Types = ApiReach.Mark([.. engine, .. editor, .. packages.SelectMany(p => p.Types), .. runner, .. editorRunner], words);
        differences = differ?.Invoke(Types) ?? [];

        Engine = Emit("UnityEngine", engine, NetStandard);
        Editor = Emit("UnityEditor", editor, [.. NetStandard, Engine]);
        var made = new Dictionary<string, MetadataReference>();
        foreach (var (name, types) in packages)
            made.Add(name, types.Count == 0 ? Engine : Emit(name, types, [.. NetStandard, Engine, .. made.Values.Distinct()]));
        Packages = made;
        EngineTestRunner = Emit("UnityEngine.TestRunner", runner, [.. NetStandard, Engine, Editor, NUnit]);
        EditorTestRunner = Emit("UnityEditor.TestRunner", editorRunner, [.. NetStandard, Engine, Editor, NUnit, EngineTestRunner]);
    }

    private const string Attribute = """
        namespace System.Diagnostics.CodeAnalysis { public sealed class ExperimentalAttribute : Attribute { public ExperimentalAttribute(string id) { } } }
        """;

    private MetadataReference Emit(string name, IReadOnlyList<ApiTypeNode> types, IEnumerable<MetadataReference> references)
    {
        var source = StubWriter.Write(types, DiagnosticOf) + (name == "UnityEngine" ? Attribute : "");
        var compilation = CSharpCompilation.Create(name, [CSharpSyntaxTree.ParseText(source, new CSharpParseOptions(LanguageVersion.Latest))], references,
            new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary, allowUnsafe: true, warningLevel: 0));
        // Explicit interface implementations, private constructors and the like are in no list, so the stubs
        // have declaration errors that do not matter for their signatures; syntax errors would hide members.
        var syntaxErrors = compilation.GetParseDiagnostics().Where(d => d.Severity == DiagnosticSeverity.Error).ToList();
        if (syntaxErrors.Count > 0)
            throw new InvalidOperationException($"The reference assembly {name} could not be made: {string.Join("; ", syntaxErrors.Take(3))}");
        return compilation.ToMetadataReference();
    }

    private string? DiagnosticOf(ApiTypeNode type, ApiEntry entry)
    {
        var lines = 0;
        for (var i = 0; i < differences.Count; i++)
            if (differences[i].Concerns(type, entry)) lines |= 1 << i;
        var editorOnly = editorOnlyMembers.Contains(entry.DocumentationId);
        var optional = entry.Kind == 'T' && optionalModules.Contains(entry.Module);
        return lines == 0 && !editorOnly && !optional ? null : $"{Marked}{lines:x2}{(editorOnly ? "E" : "")}{(optional ? "M" : "")}";
    }

    private static string Metadata(string key) =>
        Assembly.GetExecutingAssembly().GetCustomAttributes<AssemblyMetadataAttribute>().First(a => a.Key == key).Value!;
}
