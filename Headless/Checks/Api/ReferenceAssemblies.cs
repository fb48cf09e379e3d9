using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using System.Collections.Concurrent;
using System.Reflection;

namespace Headless.Checks.Api;

/// <summary>Signature-only assemblies of one Unity line, made from its API lists.</summary>
internal sealed class ReferenceAssemblies
{
    public MetadataReference Engine { get; }
    public MetadataReference Editor { get; }
    public MetadataReference EngineTestRunner { get; }
    public MetadataReference EditorTestRunner { get; }
    public IReadOnlyDictionary<string, MetadataReference> Packages { get; }
    public int MemberCount { get; }

    public static IReadOnlyList<MetadataReference> NetStandard { get; } =
        Directory.GetFiles(Metadata("NetStandardReferences"), "*.dll").Select(f => (MetadataReference)MetadataReference.CreateFromFile(f)).ToList();

    public static MetadataReference NUnit { get; } = MetadataReference.CreateFromFile(Metadata("NUnitFramework"));

    private static readonly ConcurrentDictionary<string, ReferenceAssemblies> made = new();

    public static ReferenceAssemblies Of(string line) => made.GetOrAdd(line, l => new ReferenceAssemblies(ApiList.Load(l)));

    private ReferenceAssemblies(ApiList list)
    {
        MemberCount = list.All.Count();
        Engine = Emit("UnityEngine", list.Engine, NetStandard);
        Editor = Emit("UnityEditor", list.Editor, [.. NetStandard, Engine]);
        var packages = new Dictionary<string, MetadataReference>();
        foreach (var (name, entries) in list.Packages)
            packages.Add(name, Emit(name, entries, [.. NetStandard, Engine, .. packages.Values]));
        Packages = packages;
        var runner = list.TestFramework.Where(e => e.Module == "UnityEngine.TestRunner");
        var editorRunner = list.TestFramework.Where(e => e.Module == "UnityEditor.TestRunner");
        EngineTestRunner = Emit("UnityEngine.TestRunner", runner, [.. NetStandard, Engine, Editor, NUnit]);
        EditorTestRunner = Emit("UnityEditor.TestRunner", editorRunner, [.. NetStandard, Engine, Editor, NUnit, EngineTestRunner]);
    }

    private static MetadataReference Emit(string name, IEnumerable<ApiEntry> entries, IEnumerable<MetadataReference> references)
    {
        var source = StubWriter.Write(ApiTypeNode.Build(entries));
        var compilation = CSharpCompilation.Create(name, [CSharpSyntaxTree.ParseText(source, new CSharpParseOptions(LanguageVersion.Latest))], references,
            new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary, allowUnsafe: true, warningLevel: 0));
        // Explicit interface implementations, private constructors and the like are in no list, so the stubs
        // have declaration errors that do not matter for their signatures; syntax errors would hide members.
        var syntaxErrors = compilation.GetParseDiagnostics().Where(d => d.Severity == DiagnosticSeverity.Error).ToList();
        if (syntaxErrors.Count > 0)
            throw new InvalidOperationException($"The reference assembly {name} could not be made: {string.Join("; ", syntaxErrors.Take(3))}");
        return compilation.ToMetadataReference();
    }

    private static string Metadata(string key) =>
        Assembly.GetExecutingAssembly().GetCustomAttributes<AssemblyMetadataAttribute>().First(a => a.Key == key).Value!;
}
