using System.Text.Json;
using Headless.Files;
using Headless.Shaders;

namespace Headless.Importers.Project;

/// <summary>
/// The files of a Unity project by GUID and by path. Asset paths are Unity's: <c>Assets/...</c> and
/// <c>Packages/&lt;package name&gt;/...</c>, with forward slashes. Folders whose name ends in <c>~</c> are left out,
/// as in the Editor, until <see cref="MountSample"/> adds one as if the user had imported that sample.
/// </summary>
public sealed class ProjectIndex
{
    private readonly Dictionary<string, string> pathByGuid = [];
    private readonly Dictionary<string, string> guidByPath = new(StringComparer.Ordinal);
    private readonly SortedDictionary<string, string> packageFolders = new(StringComparer.Ordinal);
    private readonly HashSet<string> mounted = new(StringComparer.Ordinal);
    private readonly List<string> missingMetas = [];

    public ProjectIndex(string root)
    {
        Root = Path.TrimEndingDirectorySeparator(Path.GetFullPath(root));
        if (!Directory.Exists(Root)) throw new ImportException($"Project folder '{root}' does not exist.");
        if (!Directory.Exists(Path.Combine(Root, "Assets")) && !Directory.Exists(Path.Combine(Root, "Packages")))
            throw new ImportException($"'{root}' is not a Unity project: it has neither an Assets nor a Packages folder.");
        FindPackages();
        FindPackagesElsewhere();
        IndexFolder(Path.Combine(Root, "Assets"), "Assets");
        foreach (var (name, folder) in packageFolders) IndexFolder(folder, "Packages/" + name);
    }

    public string Root { get; }

    /// <summary>Packages by name: the project's own, those that its manifest names by folder, and those that the Editor fetched.</summary>
    public IReadOnlyDictionary<string, string> Packages => packageFolders;

    /// <summary>All asset paths, in ordinal order.</summary>
    public IEnumerable<string> AssetPaths => guidByPath.Keys.Order(StringComparer.Ordinal);

    /// <summary>Assets without a .meta: no reference can point at them.</summary>
    public IReadOnlyList<string> MissingMetas => missingMetas;

    /// <summary>Packages that manifest.json asks for and that are nowhere.</summary>
    public IReadOnlyList<string> MissingPackages { get; private set; } = [];

    public string? PathOf(string guid) => pathByGuid.GetValueOrDefault(guid);

    public string? GuidOf(string assetPath) => guidByPath.GetValueOrDefault(assetPath);

    /// <summary>Asset path to file. Package paths go by the package's name, not its folder's.</summary>
    public string FileOf(string assetPath)
    {
        string[] parts = assetPath.Split('/', 3);
        if (parts is ["Packages", var name, ..] && packageFolders.TryGetValue(name, out string? folder))
            return parts.Length > 2 ? Path.Combine(folder, parts[2]) : folder;
        return Path.Combine(Root, assetPath);
    }

    /// <summary>File, absolute or relative to the project or to the current folder, to asset path; null when it is not inside the project.</summary>
    public string? AssetPathOf(string file)
    {
        file = file.Replace('\\', '/');
        if (!Path.IsPathRooted(file) && File.Exists(FileOf(file))) file = FileOf(file);
        string full = Path.GetFullPath(file);
        foreach (var (name, folder) in packageFolders)
            if (Inside(full, folder)) return "Packages/" + name + "/" + Path.GetRelativePath(folder, full).Replace('\\', '/');
        return Inside(full, Root) ? Path.GetRelativePath(Root, full).Replace('\\', '/') : null;
    }

    /// <summary>For a path inside <c>Samples~/Name/</c>, indexes that sample's folder; does nothing for other paths.</summary>
    public void MountSample(string assetPath)
    {
        string[] parts = assetPath.Split('/');
        int tilde = Array.FindIndex(parts, p => p.EndsWith('~'));
        if (tilde < 0) return;
        string sample = string.Join('/', parts.Take(Math.Min(tilde + 2, parts.Length - 1)));
        if (mounted.Add(sample)) IndexFolder(FileOf(sample), sample);
    }

    private static bool Inside(string file, string folder) => file.StartsWith(folder + Path.DirectorySeparatorChar, StringComparison.Ordinal);

    private void FindPackages()
    {
        string packages = Path.Combine(Root, "Packages");
        if (!Directory.Exists(packages)) return;
        foreach (string folder in Directory.EnumerateDirectories(packages).Order(StringComparer.Ordinal))
        {
            string manifest = Path.Combine(folder, "package.json");
            if (!File.Exists(manifest)) continue;
            using JsonDocument json = JsonFile.Read(manifest);
            string name = JsonFile.Text(json, "name", manifest)
                ?? throw new ImportException($"{manifest}: not a package manifest: \"name\" is missing. Add it, as \"com.company.package\".");
            if (!packageFolders.TryAdd(name, folder))
                throw new ImportException($"Packages '{packageFolders[name]}' and '{folder}' have the same name '{name}'. Remove or rename one.");
        }
    }

    /// <summary>"file:" entries of manifest.json, and what the Editor has put into Library/PackageCache.</summary>
    private void FindPackagesElsewhere()
    {
        var folders = new PackageFolders(Root);
        MissingPackages = folders.Missing;
        foreach (PackageFolders.Package package in folders.All)
            if (!package.Name.StartsWith(PackageFolders.UnitysOwn, StringComparison.Ordinal)) packageFolders.TryAdd(package.Name, package.Folder);
    }

    private void IndexFolder(string folder, string assetPath)
    {
        if (!Directory.Exists(folder)) return;
        foreach (string entry in Directory.EnumerateFileSystemEntries(folder).Order(StringComparer.Ordinal))
        {
            string name = Path.GetFileName(entry);
            if (name.StartsWith('.') || name.EndsWith('~') || name.EndsWith(".meta", StringComparison.Ordinal) || name.EndsWith(".tmp", StringComparison.Ordinal)) continue;
            string path = assetPath + "/" + name;
            Register(entry, path);
            if (Directory.Exists(entry)) IndexFolder(entry, path);
        }
    }

    private void Register(string file, string path)
    {
        string meta = file + ".meta";
        if (!File.Exists(meta))
        {
            missingMetas.Add(path);
            return;
        }
        string guid = MetaFile.ReadGuid(meta);
        if (pathByGuid.TryGetValue(guid, out string? other))
            throw new ImportException($"'{other}' and '{path}' have the same GUID {guid}. Delete the .meta of the copy and let the Editor write a new one.");
        pathByGuid[guid] = path;
        guidByPath[path] = guid;
    }
}
