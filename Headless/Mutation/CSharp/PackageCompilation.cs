using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

namespace Headless.Mutation.CSharp;

/// <summary>Compiles the package's runtime assembly in memory, as its project does for the player.</summary>
internal sealed class PackageCompilation
{
    public const string AssemblyName = "SphFluid";
    private readonly string package;
    private readonly CSharpCompilation whole;
    private readonly Dictionary<string, SyntaxTree> trees = new(StringComparer.Ordinal);

    /// <param name="package">Folder of the package.</param>
    /// <param name="references">Folder with the engine's assemblies.</param>
    public PackageCompilation(string package, string references)
    {
        this.package = package;
        foreach (string path in Directory.EnumerateFiles(Path.Combine(package, "Runtime"), "*.cs", SearchOption.AllDirectories).Order(StringComparer.Ordinal))
        {
            string file = Path.GetRelativePath(package, path).Replace('\\', '/');
            trees.Add(file, Parse(file, File.ReadAllText(path)));
        }
        string framework = Path.GetDirectoryName(typeof(object).Assembly.Location)!;
        IEnumerable<string> system = ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!).Split(Path.PathSeparator)
            .Where(p => Path.GetDirectoryName(p) == framework);
        IEnumerable<string> engine = Directory.EnumerateFiles(references, "*.dll").Where(p => Path.GetFileNameWithoutExtension(p) != AssemblyName);
        whole = CSharpCompilation.Create(AssemblyName, trees.Values,
            system.Concat(engine).Select(p => MetadataReference.CreateFromFile(p)),
            new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary, optimizationLevel: OptimizationLevel.Release, deterministic: true, allowUnsafe: true));
    }

    public static CSharpParseOptions ParseOptions { get; } = new(LanguageVersion.CSharp9, preprocessorSymbols:
    [
        "UNITY_5_3_OR_NEWER", "UNITY_2022_3_OR_NEWER", "UNITY_INCLUDE_TESTS", "UNITY_ASSERTIONS", "ENABLE_MONO", "UNITY_STANDALONE", "UNITY_STANDALONE_LINUX",
        "SPHFLUID_TERRAIN", "SPHFLUID_VEHICLES", "TRACE", "RELEASE", "NET", "NET10_0", "NETCOREAPP",
    ]);

    public IEnumerable<string> Files => trees.Keys;

    public SyntaxTree Tree(string file) => trees[file];

    /// <summary>The assembly with other text in some files; null when that does not compile. The same code gives the same bytes.</summary>
    public byte[]? Emit(IEnumerable<(string File, string Text)> changes, out string problem)
    {
        CSharpCompilation changed = whole;
        foreach ((string file, string text) in changes)
            changed = trees.TryGetValue(file, out SyntaxTree? old)
                ? changed.ReplaceSyntaxTree(old, Parse(file, text))
                : changed.AddSyntaxTrees(Parse(file, text));
        using var stream = new MemoryStream();
        var result = changed.Emit(stream);
        problem = string.Join("; ", result.Diagnostics.Where(d => d.Severity == DiagnosticSeverity.Error).Take(2));
        return result.Success ? stream.ToArray() : null;
    }

    private SyntaxTree Parse(string file, string text) =>
        CSharpSyntaxTree.ParseText(text, ParseOptions, Path.Combine(package, file), System.Text.Encoding.UTF8);
}
