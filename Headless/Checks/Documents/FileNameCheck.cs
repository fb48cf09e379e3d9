using System.Text.RegularExpressions;

namespace Headless.Checks.Documents;

/// <summary>
/// A file, a folder or a test that a document names in code is in the project: a path from the document, the project, one of its packages
/// or the player's folder, or a name alone anywhere. Files that the programs write are those whose names their sources have.
/// </summary>
internal sealed partial class FileNameCheck(ProjectPackages packages)
{
    // Of scripts that the Editor is to import the last is .txt: case.py.txt.
    private static readonly string[] sourceKinds = [".cs", ".sh", ".py", ""];
    private readonly HashSet<string> names = [];
    private readonly HashSet<string> written = [];
    private readonly List<string> roots = [];

    public CheckReport Run()
    {
        var report = new CheckReport("file names");
        ReadProject();
        var count = 0;
        foreach (var document in MarkdownFile.FindAll(packages))
            foreach (var (code, line) in document.InlineCode())
            {
                if (!IsFile(code) || IsMadeUp(code)) continue;
                count++;
                if (!Exists(document, code)) report.Findings.Add($"{document.Shown}({line}): there is no '{code}'");
            }
        report.Figures = $"{count} names of files";
        return report;
    }

    private void ReadProject()
    {
        roots.AddRange([packages.Project, .. packages.All, Path.Combine(packages.Project, "Headless"), .. packages.All.Select(p => Path.Combine(p, "Runtime"))]);
        foreach (var file in Files(packages.Project))
        {
            names.Add(Path.GetFileName(file));
            var source = Path.GetFileName(file).EndsWith(".py.txt", StringComparison.Ordinal) ? file[..^4] : file;
            if (!sourceKinds.Contains(Path.GetExtension(source))) continue;
            foreach (Match name in Written().Matches(File.ReadAllText(file))) written.Add(name.Value);
        }
    }

    private static IEnumerable<string> Files(string folder) => Directory.GetFiles(folder)
        .Concat(Directory.GetDirectories(folder).Where(d => Path.GetFileName(d) is not ("Build" or "bin" or "obj" or "Library" or ".git")).SelectMany(Files));

    private static bool IsFile(string code) => PathName().IsMatch(code) || NameAlone().IsMatch(code) || TestClass().IsMatch(code);

    // DIR/scene.csv, XPass.cs, name.1.ply, Build/play: what the reader names, and what a command makes.
    private static bool IsMadeUp(string code) => MadeUp().IsMatch(code) || code.StartsWith("Build/", StringComparison.Ordinal) || code.Contains('…') || code.Contains('*');

    private bool Exists(MarkdownFile document, string code)
    {
        if (TestClass().IsMatch(code)) return names.Contains(code.Split('.')[0] + ".cs");
        if (!code.Contains('/')) return names.Contains(code) || written.Contains(code);
        var folder = Path.GetDirectoryName(document.Path)!;
        return roots.Prepend(folder).Any(r => Path.Combine(r, code) is var path && (File.Exists(path) || Directory.Exists(path)))
            || code.StartsWith("Packages/", StringComparison.Ordinal) && PackageCache().IsMatch(code) || written.Contains(code) || written.Contains(Path.GetFileName(code));
    }

    private const string Kinds = "cs|csv|json|ply|obj|png|svg|gp|mp4|gif|webp|md|txt|sh|hlsl|cginc|compute|shader|asset|unity|prefab|mat|asmdef|slnx|csproj|gz|c|h|log";

    [GeneratedRegex(@"^\.{0,2}/?(?:[\w.~-]+/)+(?:[\w.~-]+)?$")] private static partial Regex PathName();
    [GeneratedRegex($@"^[\w.-]+\.(?:{Kinds})$")] private static partial Regex NameAlone();
    [GeneratedRegex(@"^[A-Z]\w+Tests(?:\.\w+)?$")] private static partial Regex TestClass();
    [GeneratedRegex(@"(?:^|/)(?:DIR|NAME|FILE|DEVICE|CASE|OWNER|X|name|case|frame)\b|NAME|DEVICE|DAY|(?:^|/)X(?:Pass|Tests)?\.|…")] private static partial Regex MadeUp();
    [GeneratedRegex($@"[\w-]+\.(?:{Kinds})\b|(?<="")[\w-]+/(?=\{{)")] private static partial Regex Written();
    [GeneratedRegex(@"^Packages/(?!com\.sphfluid)")] private static partial Regex PackageCache();
}
