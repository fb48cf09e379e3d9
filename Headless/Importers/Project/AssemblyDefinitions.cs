using System.Text.Json;
using Headless.Files;

namespace Headless.Importers.Project;

/// <summary>Which assembly a script belongs to: the nearest .asmdef (or .asmref) above it, else Unity's predefined assemblies.</summary>
public sealed class AssemblyDefinitions
{
    private readonly Dictionary<string, string> nameByFolder = new(StringComparer.Ordinal);
    private readonly Dictionary<string, AssemblyDefinition> byName = new(StringComparer.Ordinal);

    public AssemblyDefinitions(ProjectIndex index)
    {
        var references = new List<(string Folder, string Target, string Path)>();
        foreach (string path in index.AssetPaths)
        {
            bool isDefinition = path.EndsWith(".asmdef", StringComparison.Ordinal);
            if (!isDefinition && !path.EndsWith(".asmref", StringComparison.Ordinal)) continue;
            string folder = path[..path.LastIndexOf('/')];
            using JsonDocument json = JsonFile.Read(index.FileOf(path));
            string name = Text(json, isDefinition ? "name" : "reference", path);
            if (!isDefinition)
            {
                references.Add((folder, name, path));
                continue;
            }
            nameByFolder[folder] = name;
            if (!byName.TryAdd(name, new AssemblyDefinition(name, path, IsEditorOnly(json))))
                throw new ImportException($"'{byName[name].Path}' and '{path}' define the same assembly '{name}'. Rename one.");
        }
        foreach (var (folder, target, path) in references)
            nameByFolder[folder] = target.StartsWith("GUID:", StringComparison.Ordinal) ? NameOfGuid(index, target[5..], path) : target;
    }

    public IReadOnlyCollection<AssemblyDefinition> All => byName.Values;

    /// <summary>Assembly name (no extension) for a script at this asset path.</summary>
    public string AssemblyOf(string scriptPath)
    {
        for (int slash = scriptPath.LastIndexOf('/'); slash > 0; slash = scriptPath.LastIndexOf('/', slash - 1))
            if (nameByFolder.TryGetValue(scriptPath[..slash], out string? name)) return name;
        return scriptPath.Contains("/Editor/", StringComparison.Ordinal) ? "Assembly-CSharp-Editor" : "Assembly-CSharp";
    }

    private string NameOfGuid(ProjectIndex index, string guid, string path)
    {
        string? target = index.PathOf(guid);
        return byName.Values.FirstOrDefault(d => d.Path == target)?.Name
            ?? throw new ImportException($"{path}: the assembly definition with GUID {guid} is not in the project.");
    }

    private static bool IsEditorOnly(JsonDocument json) =>
        json.RootElement.TryGetProperty("includePlatforms", out JsonElement platforms)
        && platforms.ValueKind == JsonValueKind.Array && platforms.GetArrayLength() == 1
        && platforms[0].ValueKind == JsonValueKind.String && platforms[0].GetString() == "Editor";

    private static string Text(JsonDocument json, string key, string path) =>
        JsonFile.Text(json, key, path) is { Length: > 0 } text
            ? text
            : throw new ImportException($"{path}: \"{key}\" is missing. Add it: it names the assembly.");
}
