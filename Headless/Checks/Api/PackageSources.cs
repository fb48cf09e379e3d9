using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Headless.Checks.Api;

/// <summary>C# of assemblies, read once and parsed once for each set of defines that it asks for.</summary>
internal sealed class PackageSources
{
    private readonly Dictionary<string, Source> sources = [];

    public PackageSources(IEnumerable<PackageAssembly> assemblies)
    {
        foreach (var file in assemblies.SelectMany(a => a.SourceFiles())) sources.Add(file, new Source(file, File.ReadAllText(file)));
        Words = sources.Values.SelectMany(s => s.Words).ToHashSet();
    }

    /// <summary>All that may be a name in them, comments included.</summary>
    public HashSet<string> Words { get; }

    public IEnumerable<SyntaxTree> Parse(PackageAssembly assembly, IReadOnlyCollection<string> defines) => assembly.SourceFiles().Select(f => sources[f].Parse(defines));

    public Source Of(SyntaxTree tree) => sources[tree.FilePath];

    public static HashSet<string> WordsOf(string text)
    {
        HashSet<string> words = [];
        var lookup = words.GetAlternateLookup<ReadOnlySpan<char>>();
        for (var i = 0; i < text.Length; i++)
        {
            var start = i;
            while (i < text.Length && (char.IsLetterOrDigit(text[i]) || text[i] == '_')) i++;
            if (i > start) lookup.Add(text.AsSpan(start, i - start));
        }
        return words;
    }

    /// <summary>Types of a file and their members, without their bodies.</summary>
    public static IEnumerable<MemberDeclarationSyntax> Declarations(SyntaxTree tree) =>
        tree.GetRoot().DescendantNodes(n => n is CompilationUnitSyntax or BaseNamespaceDeclarationSyntax or TypeDeclarationSyntax).OfType<MemberDeclarationSyntax>();

    internal sealed record Source(string File, string Text)
    {
        private readonly Dictionary<string, SyntaxTree> trees = [];
        private readonly string directives = string.Join('\n', Text.Split('\n').Where(l => l.TrimStart().StartsWith('#')));

        public HashSet<string> Words { get; } = WordsOf(Text);

        public SyntaxTree Parse(IReadOnlyCollection<string> defines)
        {
            string[] asked = [.. defines.Where(directives.Contains)];
            var key = string.Join(' ', asked);
            if (!trees.TryGetValue(key, out var tree))
                trees.Add(key, tree = CSharpSyntaxTree.ParseText(Text, new CSharpParseOptions(LanguageVersion.CSharp9, DocumentationMode.Diagnose, preprocessorSymbols: asked), File));
            return tree;
        }
    }
}
