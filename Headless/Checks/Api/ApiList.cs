using System.IO.Compression;
using System.Reflection;

namespace Headless.Checks.Api;

/// <summary>The public API of one Unity line ("2022.3" or "6000.0"), one entry a member.</summary>
internal sealed class ApiList
{
    public static readonly string[] Lines = ["2022.3", "6000.0"];

    public string Line { get; }
    public IReadOnlyList<ApiEntry> Engine { get; }
    public IReadOnlyList<ApiEntry> Editor { get; }
    public IReadOnlyList<ApiEntry> TestFramework { get; }

    /// <summary>Packages that the fluid package uses, each after those it builds on: by assembly name, members that a player build has.</summary>
    public IReadOnlyList<KeyValuePair<string, IReadOnlyList<ApiEntry>>> Packages { get; }

    private ApiList(string line)
    {
        Line = line;
        Engine = Read($"{line}/engine.txt.gz");
        Editor = Read($"{line}/editor.txt.gz");
        TestFramework = Read($"{line}/test-framework.txt.gz");
        Packages =
        [
            Package("Unity.Burst", "burst"),
            Package("Unity.Mathematics", "mathematics"),
            Package("Unity.RenderPipelines.Core.Runtime", "render-pipelines.core"),
            Package("Unity.RenderPipelines.Universal.Runtime", "render-pipelines.universal"),
        ];

        KeyValuePair<string, IReadOnlyList<ApiEntry>> Package(string assembly, string list) => new(assembly, OfPlayer(Read($"{line}/{list}.txt.gz")));
    }

    public IEnumerable<ApiEntry> All => Engine.Concat(Editor).Concat(TestFramework).Concat(Packages.SelectMany(p => p.Value));

    public static ApiList Load(string line) => new(line);

    private static List<ApiEntry> OfPlayer(List<ApiEntry> entries) => entries.FindAll(e => !e.IsEditorOnly);

    public static IReadOnlySet<string> LoadEditorOnlyMembers()
    {
        using var reader = new StreamReader(Open("EditorOnlyMembers.txt"));
        return reader.ReadToEnd().Split('\n', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries).ToHashSet();
    }

    private static List<ApiEntry> Read(string resource)
    {
        using var reader = new StreamReader(new GZipStream(Open(resource), CompressionMode.Decompress));
        var entries = new List<ApiEntry>();
        while (reader.ReadLine() is { } line)
            if (line.Length > 2 && line[1] == ':') entries.Add(ApiEntry.Parse(line));
        return entries;
    }

    private static Stream Open(string resource) =>
        Assembly.GetExecutingAssembly().GetManifestResourceStream(resource.Replace('\\', '/'))
        ?? throw new FileNotFoundException($"The API list '{resource}' is not embedded in the checks program.");
}
