using System.Text.Json;

namespace Headless.Shaders;

/// <summary>Folders of a project's packages by package name.</summary>
/// <remarks>Embedded packages (Packages/*), "file:" entries of Packages/manifest.json, then Library/PackageCache.</remarks>
public sealed class PackageFolders
{
    public sealed record Package(string Name, string Version, string Folder);

    private readonly Dictionary<string, Package> _packages = [];

    public PackageFolders(string projectRoot)
    {
        string packages = Path.Combine(projectRoot, "Packages");
        AddAll(packages);
        AddLocal(packages);
        AddAll(Path.Combine(projectRoot, "Library", "PackageCache"));
    }

    public Package? Find(string name) => _packages.GetValueOrDefault(name);

    private void AddAll(string folder)
    {
        if (!Directory.Exists(folder))
        {
            return;
        }
        foreach (string package in Directory.GetDirectories(folder).Order(StringComparer.Ordinal))
        {
            Add(package);
        }
    }

    private void AddLocal(string packages)
    {
        string manifest = Path.Combine(packages, "manifest.json");
        if (!File.Exists(manifest))
        {
            return;
        }
        using JsonDocument document = Parse(manifest);
        if (!document.RootElement.TryGetProperty("dependencies", out JsonElement dependencies))
        {
            return;
        }
        foreach (JsonProperty entry in dependencies.EnumerateObject())
        {
            if (entry.Value.GetString() is { } value && value.StartsWith("file:", StringComparison.Ordinal))
            {
                Add(Path.GetFullPath(Path.Combine(packages, value["file:".Length..])));
            }
        }
    }

    private void Add(string folder)
    {
        string file = Path.Combine(folder, "package.json");
        if (!File.Exists(file))
        {
            return;
        }
        using JsonDocument document = Parse(file);
        string? name = Text(document, "name");
        if (name is not null)
        {
            _packages.TryAdd(name, new Package(name, Text(document, "version") ?? "0.0.0", folder));
        }
    }

    private static string? Text(JsonDocument document, string property) =>
        document.RootElement.TryGetProperty(property, out JsonElement value) ? value.GetString() : null;

    private static JsonDocument Parse(string file)
    {
        try
        {
            return JsonDocument.Parse(File.ReadAllText(file));
        }
        catch (JsonException e)
        {
            throw new InvalidDataException($"{file} is not valid JSON: {e.Message}", e);
        }
    }
}
