using System.Text.Json;

namespace Headless.Checks;

/// <summary>The packages that a project embeds: the folders of Packages with a package.json. The product comes first, the rest follow by name.</summary>
internal sealed class ProjectPackages
{
    /// <summary>What a game installs.</summary>
    public const string ProductName = "com.sphfluid";

    public ProjectPackages(string project)
    {
        Project = project;
        Folder = Path.Combine(project, "Packages");
        Product = Path.Combine(Folder, ProductName);
        All = [.. Directory.GetDirectories(Folder).Where(f => f == Product || File.Exists(Path.Combine(f, "package.json")))
            .OrderBy(f => f != Product).ThenBy(f => f, StringComparer.Ordinal)];
    }

    public string Project { get; }

    /// <summary>The project's folder Packages.</summary>
    public string Folder { get; }

    /// <summary>Root of the product.</summary>
    public string Product { get; }

    /// <summary>Root of every package.</summary>
    public IReadOnlyList<string> All { get; }

    /// <summary>A package and those of the project that it builds on: what its package.json names, and what that needs.</summary>
    public IReadOnlySet<string> WithDependencies(string package)
    {
        var found = new HashSet<string> { package };
        var next = new Queue<string>(found);
        while (next.TryDequeue(out var name))
            foreach (var dependency in NamedBy(name).Where(found.Add)) next.Enqueue(dependency);
        return found;
    }

    private IEnumerable<string> NamedBy(string package)
    {
        var file = Path.Combine(package, "package.json");
        if (!File.Exists(file)) return [];
        using var json = JsonDocument.Parse(File.ReadAllText(file));
        return json.RootElement.TryGetProperty("dependencies", out var named) ? [.. named.EnumerateObject().Select(d => Path.Combine(Folder, d.Name)).Where(All.Contains)] : [];
    }

    /// <summary>Files of every package, by path.</summary>
    public IEnumerable<string> Files() => All.SelectMany(p => Directory.GetFiles(p, "*", SearchOption.AllDirectories).Order());

    /// <summary>Path of a file below its package; the product's stand alone, the others' follow their package's name.</summary>
    /// <example>Shaders/Gpu/FluidTypes.hlsl; com.sphfluid.validation/Runtime/Measure/NeighbourAudit.compute</example>
    public string NameOf(string file)
    {
        var path = Path.GetRelativePath(Folder, file).Replace('\\', '/');
        return path.StartsWith(ProductName + "/", StringComparison.Ordinal) ? path[(ProductName.Length + 1)..] : path;
    }

    /// <summary>Path of a file below its package.</summary>
    public string PathInPackage(string file)
    {
        var path = Path.GetRelativePath(Folder, file).Replace('\\', '/');
        return path[(path.IndexOf('/') + 1)..];
    }

    /// <summary>Folders with scenes, prefabs and materials that users open: the samples of every package, and Assets.</summary>
    public IEnumerable<string> SceneFolders() => All.Select(p => Path.Combine(p, "Samples~")).Append(Path.Combine(Project, "Assets")).Where(Directory.Exists);
}
