using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Headless.Checks.Api;

/// <summary>
/// Compiles every assembly of the packages and their samples as C# 9 for .NET Standard 2.1 against the real public API of each Unity line, as
/// the Editor does and, for runtime assemblies, as a player build does. Each package sees those that its package.json names and nothing else:
/// a game that installs the product alone compiles, and so does one with the product and one other package. The oldest line's Editor compiles every file; in the other passes only those files
/// are compiled that can notice a difference to it.
/// </summary>
internal sealed class ApiCheck
{
    // A leftover of projects that came from older lines: URP drew without its render graph.
    private const string Leftover = "URP_COMPATIBILITY_MODE";

    // Unity ships NUnit 3.5; the oldest framework on NuGet is 3.6, which added these.
    private static readonly string[] laterNUnit = ["M:NUnit.Framework.Assert.Multiple", "M:NUnit.Framework.Assert.Warn", "T:NUnit.Framework.Warn"];

    /// <summary>Compiler messages about members that a Unity line marks obsolete.</summary>
    internal static readonly string[] Obsolete = ["CS0612", "CS0618", "CS0619", "CS0672"];

    // Serialised fields are assigned by the Editor.
    private static readonly string[] ignored = ["CS0649", "CS0414", "CS1701", "CS1702"];

    private const string RenderPipelines = "Unity.RenderPipelines.";

    private readonly ProjectPackages packages;
    private readonly Dictionary<string, List<PackageAssembly>> assemblies;
    private readonly PackageSources sources;

    public ApiCheck(ProjectPackages packages)
    {
        this.packages = packages;
        assemblies = packages.All.ToDictionary(p => p, p => (List<PackageAssembly>)[.. PackageAssembly.FindAll(p), .. PackageAssembly.FindSamples(p)]);
        sources = new PackageSources(assemblies.Values.SelectMany(a => a));
    }

    public IEnumerable<CheckReport> Run()
    {
        var (oldest, newer) = (UnityLine.All[0], UnityLine.All.Skip(1).ToList());
        var all = assemblies.Values.SelectMany(a => a).ToList();
        string[] defines = [.. oldest.Defines(editor: true)];
        var bases = all.SelectMany(a => sources.Parse(a, defines)).SelectMany(PackageSources.Declarations).OfType<TypeDeclarationSyntax>()
            .SelectMany(t => t.BaseList?.Types ?? []).SelectMany(b => b.DescendantNodes().OfType<SimpleNameSyntax>()).Select(n => n.Identifier.ValueText).ToHashSet();
        var references = newer.ConvertAll(l => new ReferenceAssemblies(l, sources.Words));
        IReadOnlyList<ApiDifference> differences = [];
        references.Insert(0, new ReferenceAssemblies(oldest, sources.Words, types => differences = references.ConvertAll(r => new ApiDifference(types, r.Types, bases))));

        var whole = new WholePass();
        for (var i = 0; i < UnityLine.All.Count; i++)
        {
            var line = UnityLine.All[i];
            var pass = new Pass(line, references[i], Editor: true, Optional: true, i == 0 ? null : differences[i - 1])
            {
                NewerPipelines = line.HasRenderPipelinesBetween ? references[i + 1] : null,
            };
            foreach (var report in Compile(pass, whole, packages.All)) yield return report;
            foreach (var report in Compile(pass with { Editor = false }, whole, packages.All)) yield return report;
            foreach (var report in Compile(pass with { Editor = false, Optional = false }, whole, [packages.Product])) yield return report;
        }
    }

    /// <summary>What a script of a user's is compiled with in the Editor: Unity, NUnit and the packages' runtime assemblies that are referenced without asking.</summary>
    /// <param name="line">The line of Unity.</param>
    /// <param name="text">The scripts.</param>
    public (IReadOnlyList<MetadataReference> References, CSharpParseOptions Options) ReferencesForUsers(UnityLine line, string text)
    {
        var unity = new ReferenceAssemblies(line, sources.Words.Union(PackageSources.WordsOf(text)).ToHashSet());
        var pass = new Pass(line, unity, Editor: true, Optional: true, null);
        var built = new Dictionary<string, CSharpCompilation>();
        foreach (var assembly in packages.All.SelectMany(PackageAssembly.FindAll).Where(a => !a.EditorOnly && !a.IsTest && !a.IsOptional))
            built[assembly.Name] = Create(pass, assembly, built, []);
        return ([.. ReferenceAssemblies.NetStandard, unity.Engine, unity.Editor, unity.EngineTestRunner, ReferenceAssemblies.NUnit, .. unity.Packages.Values.Distinct(), .. built.Values.Select(b => b.ToMetadataReference())],
            new CSharpParseOptions(LanguageVersion.CSharp9, preprocessorSymbols: line.Defines(editor: true)));
    }

    /// <summary>What a compilation is for.</summary>
    /// <param name="Line">The line of Unity.</param>
    /// <param name="References">Its assemblies.</param>
    /// <param name="Editor">Whether the Editor compiles for itself, or for a player.</param>
    /// <param name="Optional">Whether the project has the modules of the engine that the package can do without: terrain.</param>
    /// <param name="Difference">What differs from the oldest line; null for that itself.</param>
    private sealed record Pass(UnityLine Line, ReferenceAssemblies References, bool Editor, bool Optional, ApiDifference? Difference)
    {
        /// <summary>The next line's, where the render pipelines lie between the two.</summary>
        public ReferenceAssemblies? NewerPipelines { get; init; }

        public int Bit => 1 << (UnityLine.All.ToList().IndexOf(Line) - 1);
    }

    /// <summary>What the first pass, which compiles every file, leaves for the others: its files, and what uses of the API they have.</summary>
    private sealed class WholePass
    {
        public Dictionary<string, SyntaxTree> Trees { get; } = [];

        /// <summary>Files that another line, a player or a project without modules may see otherwise.</summary>
        public ILookup<string, string> Marks { get; set; } = Array.Empty<string>().ToLookup(s => s);

        /// <summary>Names whose declarations hang on defines.</summary>
        public HashSet<string> Changed(IEnumerable<SyntaxTree> trees) => trees.Where(t => Trees[t.FilePath] != t).SelectMany(t =>
        {
            var (here, before) = (Heads(t), Heads(Trees[t.FilePath]));
            return here.Except(before).Concat(before.Except(here)).Select(h => h.Name);
        }).ToHashSet();

        public bool Concerns(Pass pass, SyntaxTree tree, PackageSources.Source file, HashSet<string> changed) =>
            Trees[tree.FilePath] != tree || changed.Overlaps(file.Words) || Marks[tree.FilePath].Any(m => Concerns(pass, m))
            || (pass.Difference?.Concerns(file) ?? false) || (!pass.Editor && file.Words.Contains("UnityEditor"));

        private static bool Concerns(Pass pass, string mark) => !mark.StartsWith(ReferenceAssemblies.Marked, StringComparison.Ordinal)
            || (pass.Difference is not null && (LinesOf(mark) & pass.Bit) != 0)
            || (!pass.Editor && mark.Contains('E')) || (!pass.Optional && mark.Contains('M'));

        // Declarations without their bodies.
        private static HashSet<(string Name, string Text)> Heads(SyntaxTree tree) => PackageSources.Declarations(tree).SelectMany(Heads).ToHashSet();

        private static IEnumerable<(string Name, string Text)> Heads(MemberDeclarationSyntax declaration) => declaration switch
        {
            TypeDeclarationSyntax type => [(type.Identifier.ValueText, $"{type.Modifiers} {type.TypeParameterList} {type.BaseList}")],
            MethodDeclarationSyntax method => [(method.Identifier.ValueText, method.ToString()[..(method.ParameterList.Span.End - method.SpanStart)])],
            ConstructorDeclarationSyntax made => [(made.Identifier.ValueText, $"{made.Modifiers} {made.ParameterList}")],
            PropertyDeclarationSyntax property => [(property.Identifier.ValueText, $"{property.Modifiers} {property.Type}")],
            BaseFieldDeclarationSyntax field => field.Declaration.Variables.Select(v => (v.Identifier.ValueText, $"{field.Modifiers} {field.Declaration.Type}")),
            BaseTypeDeclarationSyntax or DelegateDeclarationSyntax => [(declaration.DescendantTokens().First(t => t.IsKind(SyntaxKind.IdentifierToken)).ValueText, declaration.ToString())],
            _ => [],
        };
    }

    private IEnumerable<CheckReport> Compile(Pass pass, WholePass whole, IReadOnlyList<string> order)
    {
        var all = new Dictionary<string, (string Package, CSharpCompilation Compilation)>();
        var isWhole = whole.Trees.Count == 0;
        var marks = new List<(string File, string Mark)>();
        HashSet<string> changed = [];
        foreach (var package in order)
        {
            var report = new CheckReport($"API {pass.Line} {(pass.Editor ? "Editor" : "player")}, {Path.GetFileName(package)}{(pass.Optional ? "" : " without modules")}");
            var findings = pass.Line.IsAlpha ? report.Notes : report.Findings;
            var mine = assemblies[package].FindAll(a => pass.Editor || !(a.EditorOnly || a.IsTest));
            var dependencies = packages.WithDependencies(package);
            var built = all.Where(a => dependencies.Contains(a.Value.Package)).ToDictionary(a => a.Key, a => a.Value.Compilation);
            foreach (var assembly in mine)
            {
                built[assembly.Name] = Create(pass, assembly, built, findings);
                all[assembly.Name] = (package, built[assembly.Name]);
            }
            if (!isWhole) changed.UnionWith(whole.Changed(mine.SelectMany(a => built[a.Name].SyntaxTrees)));
            var files = 0;
            foreach (var assembly in mine)
            {
                var compilation = built[assembly.Name];
                var trees = isWhole ? [.. compilation.SyntaxTrees] : compilation.SyntaxTrees.Where(t => whole.Concerns(pass, t, sources.Of(t), changed)).ToList();
                files += trees.Count;
                var diagnostics = isWhole ? compilation.GetDiagnostics() : trees.SelectMany(t => compilation.GetSemanticModel(t).GetDiagnostics());
                foreach (var variant in Variants(pass, assembly, built))
                    foreach (var diagnostic in variant.Compilation.GetDiagnostics().Where(d => IsFinding(d, pass, assembly)))
                        findings.Add($"{assembly.Name} {variant.Name}: {Describe(diagnostic)}");
                foreach (var diagnostic in diagnostics)
                {
                    var isFinding = IsFinding(diagnostic, pass, assembly);
                    if (isFinding) findings.Add($"{assembly.Name}: {Describe(diagnostic)}");
                    if ((isFinding || IsMark(diagnostic)) && diagnostic.Location.SourceTree is { } tree) marks.Add((tree.FilePath, diagnostic.Id));
                }
                if (isWhole && assembly.IsTest) findings.AddRange(LaterNUnit(compilation).Select(f => $"{assembly.Name}: {f}"));
            }
            report.Figures = $"{mine.Count} {(mine.Count == 1 ? "assembly compiles" : "assemblies compile")} against {pass.References.MemberCount} members, {files} files";
            yield return report;
        }
        if (!isWhole) yield break;
        whole.Marks = marks.Distinct().ToLookup(m => m.File, m => m.Mark);
        foreach (var tree in all.Values.SelectMany(b => b.Compilation.SyntaxTrees)) whole.Trees.Add(tree.FilePath, tree);
    }

    // What else an optional assembly may meet: it is small, and compiled whole.
    private IEnumerable<(string Name, CSharpCompilation Compilation)> Variants(Pass pass, PackageAssembly assembly, Dictionary<string, CSharpCompilation> built)
    {
        if (!assembly.IsOptional) yield break;
        yield return ($"with {Leftover}", Create(pass, assembly, built, [], [Leftover]));
        if (pass.NewerPipelines is { } newer) yield return ("with newer render pipelines", Create(pass, assembly, built, [], [], newer));
    }

    private CSharpCompilation Create(
        Pass pass, PackageAssembly assembly, Dictionary<string, CSharpCompilation> built, List<string> findings, string[]? more = null,
        ReferenceAssemblies? pipelines = null)
    {
        var references = pass.References;
        string[] defines = [.. pass.Line.Defines(pass.Editor), .. pass.Optional ? assembly.ModuleDefines : [], .. more ?? []];
        var metadata = new List<MetadataReference>(ReferenceAssemblies.NetStandard) { references.Engine };
        if (pass.Editor) metadata.Add(references.Editor);
        foreach (var name in assembly.References)
        {
            if (name == "UnityEngine.TestRunner") metadata.Add(references.EngineTestRunner);
            else if (name == "UnityEditor.TestRunner") metadata.Add(references.EditorTestRunner);
            else if (PackagesFor(name).Packages.TryGetValue(name, out var package)) metadata.Add(package);
            else if (built.TryGetValue(name, out var dependency)) metadata.Add(dependency.ToMetadataReference());
            else findings.Add($"{assembly.Name}: references {name}, which is neither Unity's nor of a package that it may build on");
        }
        if (assembly.IsTest) metadata.Add(ReferenceAssemblies.NUnit);
        return CSharpCompilation.Create(assembly.Name, sources.Parse(assembly, defines), metadata.Distinct(),
            new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary, warningLevel: 4, allowUnsafe: assembly.AllowsUnsafe));

        ReferenceAssemblies PackagesFor(string name) => name.StartsWith(RenderPipelines, StringComparison.Ordinal) ? pipelines ?? references : references;
    }

    private static bool IsMark(Diagnostic diagnostic) => diagnostic.Id.StartsWith(ReferenceAssemblies.Marked, StringComparison.Ordinal);

    private static int LinesOf(string mark) => Convert.ToInt32(mark.Substring(ReferenceAssemblies.Marked.Length, 2), 16);

    private static bool IsFinding(Diagnostic diagnostic, Pass pass, PackageAssembly assembly)
    {
        if (IsMark(diagnostic)) return (!pass.Editor && diagnostic.Id.Contains('E')) || (!pass.Optional && diagnostic.Id.Contains('M'));
        if (diagnostic.Severity == DiagnosticSeverity.Error || Obsolete.Contains(diagnostic.Id)) return true;
        if (diagnostic.Severity != DiagnosticSeverity.Warning || ignored.Contains(diagnostic.Id)) return false;
        return !((assembly.IsTest || assembly.IsSample) && diagnostic.Id == "CS1591");
    }

    private static string Describe(Diagnostic diagnostic)
    {
        var message = !IsMark(diagnostic) ? $"{diagnostic.Id} {diagnostic.GetMessage()}"
            : $"{diagnostic.GetMessage().Split('\'')[1]} {(diagnostic.Id.Contains('E') ? "exists only in the Editor" : "needs a module that a project may not have")}";
        return $"{Place(diagnostic.Location)}: {message}";
    }

    private static IEnumerable<string> LaterNUnit(CSharpCompilation compilation) =>
        from tree in compilation.SyntaxTrees
        from node in tree.GetRoot().DescendantNodes().OfType<SimpleNameSyntax>()
        where node.Identifier.ValueText is "Multiple" or "Warn"
        let id = compilation.GetSemanticModel(tree).GetSymbolInfo(node).Symbol?.OriginalDefinition.GetDocumentationCommentId()
        where id is not null && laterNUnit.Any(id.StartsWith)
        select $"{Place(node.GetLocation())}: {id} is newer than Unity's NUnit 3.5";

    private static string Place(Location location) => $"{Path.GetFileName(location.SourceTree?.FilePath)}({location.GetLineSpan().StartLinePosition.Line + 1})";
}
