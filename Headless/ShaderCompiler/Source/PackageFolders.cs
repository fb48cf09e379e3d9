using System.Text.Json;
using Headless.Files;

namespace Headless.Shaders;

/// <summary>Folders of a project's packages by package name.</summary>
/// <remarks>Embedded packages (Packages/*), "file:" entries of Packages/manifest.json, then Library/PackageCache.</remarks>
public sealed class PackageFolders
{
    public sealed record Package(string Name, string Version, string Folder);

    /// <summary>How the names of Unity's own packages begin.</summary>
    public const string UnitysOwn = "com.unity.";

    private readonly Dictionary<string, Package> _packages = [];
    private readonly List<string> _asked = [];

    public PackageFolders(string projectRoot)
    {
        string packages = Path.Combine(projectRoot, "Packages");
        AddAll(packages);
        AddLocal(packages);
        AddAll(Path.Combine(projectRoot, "Library", "PackageCache"));
    }

    public IEnumerable<Package> All => _packages.Values;

    /// <summary>Packages that manifest.json asks for and that are nowhere; Unity's own, which the player has stand-ins for, are left out.</summary>
    public IReadOnlyList<string> Missing => [.. _asked.Where(a => !_packages.ContainsKey(a) && !a.StartsWith(UnitysOwn, StringComparison.Ordinal))];

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
        using JsonDocument document = JsonFile.Read(manifest);
        if (!document.RootElement.TryGetProperty("dependencies", out JsonElement dependencies))
        {
            return;
        }
        if (dependencies.ValueKind != JsonValueKind.Object)
        {
            throw new BadFileException($"{manifest}: \"dependencies\" must be an object of package names and versions. Correct it.");
        }
        foreach (JsonProperty entry in dependencies.EnumerateObject())
        {
            _asked.Add(entry.Name);
            if (entry.Value.ValueKind == JsonValueKind.String && entry.Value.GetString() is { } value && value.StartsWith("file:", StringComparison.Ordinal))
            {
                Add(LocalFolder(packages, value["file:".Length..], manifest));
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
        using JsonDocument document = JsonFile.Read(file);
        string? name = JsonFile.Text(document, "name", file);
        if (name is not null)
        {
            _packages.TryAdd(name, new Package(name, JsonFile.Text(document, "version", file) ?? "0.0.0", folder));
        }
    }

    private static string LocalFolder(string packages, string path, string manifest)
    {
        try
        {
            return Path.GetFullPath(Path.Combine(packages, path));
        }
        catch (ArgumentException e)
        {
            throw new BadFileException($"{manifest}: 'file:{OneLine.Value(path)}' is no path. Correct it.", e);
        }
    }
}
