using System.IO.Compression;
using System.Reflection;

namespace Headless.Checks.Api;

/// <summary>The public API of one Unity line, one entry a member.</summary>
internal sealed class ApiList
{
    // Assemblies of packages, each after those it builds on. Where a line lists nothing for one, it is a module of the engine.
    private static readonly (string Assembly, string List)[] packages =
    [
        ("Unity.Burst", "burst"), ("Unity.Mathematics", "mathematics"),
        ("Unity.RenderPipelines.Core.Runtime", "render-pipelines.core"), ("Unity.RenderPipelines.Universal.Runtime", "render-pipelines.universal"),
    ];

    private static readonly Dictionary<string, List<(int Lines, ApiEntry Entry)>> read = [];

    public UnityLine Line { get; }
    public IReadOnlyList<ApiEntry> Engine { get; }
    public IReadOnlyList<ApiEntry> Editor { get; }
    public IReadOnlyList<ApiEntry> TestFramework { get; }

    /// <summary>Packages that the fluid package uses, each after those it builds on: by assembly name, members that a player build has.</summary>
    public IReadOnlyList<KeyValuePair<string, IReadOnlyList<ApiEntry>>> Packages { get; }

    /// <summary>Their members that only the Editor has.</summary>
    public IReadOnlyList<ApiEntry> OfPackagesInEditor { get; }

    private ApiList(UnityLine line)
    {
        Line = line;
        Engine = Of(line, "engine");
        Editor = Of(line, "editor");
        TestFramework = Of(line, "test-framework");
        Packages = [.. packages.Select(p => new KeyValuePair<string, IReadOnlyList<ApiEntry>>(p.Assembly, Of(line, p.List).FindAll(e => !e.IsEditorOnly)))];
        OfPackagesInEditor = [.. packages.SelectMany(p => Of(line, p.List)).Where(e => e.IsEditorOnly)];
    }

    public IEnumerable<ApiEntry> All => Engine.Concat(Editor).Concat(TestFramework).Concat(Packages.SelectMany(p => p.Value));

    public static ApiList Load(UnityLine line) => new(line);

    public static IReadOnlySet<string> LoadEditorOnlyMembers()
    {
        using var reader = new StreamReader(Open("EditorOnlyMembers.txt"));
        return reader.ReadToEnd().Split('\n', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries).ToHashSet();
    }

    private static List<ApiEntry> Of(UnityLine line, string list)
    {
        List<(int Lines, ApiEntry Entry)>? all;
        lock (read)
            if (!read.TryGetValue(list, out all)) read.Add(list, all = Read(list + ".txt.gz"));
        var bit = 1 << UnityLine.All.ToList().IndexOf(line);
        return [.. all.Where(e => (e.Lines & bit) != 0).Select(e => e.Entry)];
    }

    // A header that names the lines; then an entry a line, after the hexadecimal sum of the lines that have it: 1 for the first, 2 for the second, 4.
    private static List<(int, ApiEntry)> Read(string resource)
    {
        using var reader = new StreamReader(new GZipStream(Open(resource), CompressionMode.Decompress));
        var header = "# " + string.Join(' ', UnityLine.All);
        if (reader.ReadLine() is var first && first != header) throw new InvalidDataException($"{resource} begins with '{first}' and not with '{header}'.");
        var entries = new List<(int, ApiEntry)>();
        while (reader.ReadLine() is { } line)
            entries.Add((Convert.ToInt32(line[..2], 16), ApiEntry.Parse(line[3..])));
        return entries;
    }

    private static Stream Open(string resource) =>
        Assembly.GetExecutingAssembly().GetManifestResourceStream(resource.Replace('\\', '/'))
        ?? throw new FileNotFoundException($"The API list '{resource}' is not embedded in the checks program.");
}
