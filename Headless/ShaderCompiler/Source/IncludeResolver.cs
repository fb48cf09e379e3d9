using System.Collections.Concurrent;
using System.Reflection;
using Headless.Files;

namespace Headless.Shaders;

/// <summary>Finds include files by Unity's rules.</summary>
/// <remarks>
/// In this order: next to the including file, "Packages/&lt;package name&gt;/..." (by the name in package.json, not by folder),
/// "Assets/..." below the project, and the built-in files (UnityCG.cginc, ...).
/// </remarks>
public sealed class IncludeResolver
{
    /// <summary>Prefix of the names under which built-in files appear in messages.</summary>
    public const string BuiltinFolder = "CGIncludes/";

    private const int LargestFile = 8 << 20;

    private readonly ConcurrentDictionary<string, Lazy<string>> _texts = new();

    /// <exception cref="DirectoryNotFoundException">There is no such folder.</exception>
    public IncludeResolver(string projectRoot)
    {
        ProjectRoot = Path.GetFullPath(projectRoot);
        if (!Directory.Exists(ProjectRoot))
        {
            throw new DirectoryNotFoundException($"project folder '{ProjectRoot}' does not exist");
        }
        Packages = new PackageFolders(ProjectRoot);
    }

    public string ProjectRoot { get; }

    public PackageFolders Packages { get; }

    /// <summary>Full path of an include, "CGIncludes/..." for a built-in one, or null.</summary>
    /// <param name="includingFile">File that holds the directive.</param>
    public string? Resolve(string include, string includingFile)
    {
        string path = include.Replace('\\', '/');
        return Beside(path, includingFile) ?? InPackage(path) ?? InAssets(path) ?? BuiltIn(path);
    }

    /// <summary>Text of a source, or of an include file that <see cref="Resolve"/> found.</summary>
    /// <exception cref="BadFileException">It cannot be read, or is too large.</exception>
    public string Read(string path)
    {
        if (path.StartsWith(BuiltinFolder, StringComparison.Ordinal))
        {
            return _texts.GetOrAdd(path, p => new Lazy<string>(() => ReadBuiltIn(p))).Value;
        }
        return BoundedText.ReadAll(path, LargestFile);
    }

    /// <summary>A path as Unity shows it: relative to the project where it lies in it.</summary>
    public string Shown(string path)
    {
        string relative = Path.GetRelativePath(ProjectRoot, path).Replace('\\', '/');
        return relative.StartsWith("../", StringComparison.Ordinal) || Path.IsPathRooted(relative) ? path : relative;
    }

    private static string? Beside(string path, string includingFile)
    {
        if (includingFile.StartsWith(BuiltinFolder, StringComparison.Ordinal) || Path.IsPathRooted(path))
        {
            return null;
        }
        string folder = Path.GetDirectoryName(Path.GetFullPath(includingFile)) ?? "";
        return Existing(Path.Combine(folder, path));
    }

    private string? InPackage(string path)
    {
        string[] parts = path.Split('/', 3);
        return parts is ["Packages", _, _] && Packages.Find(parts[1]) is { } package
            ? Existing(Path.Combine(package.Folder, parts[2]))
            : null;
    }

    private string? InAssets(string path) =>
        path.StartsWith("Assets/", StringComparison.Ordinal) ? Existing(Path.Combine(ProjectRoot, path)) : null;

    private static string? BuiltIn(string path)
    {
        string name = BuiltinFolder + path;
        return typeof(IncludeResolver).Assembly.GetManifestResourceInfo(name) is null ? null : name;
    }

    private static string ReadBuiltIn(string name)
    {
        using Stream stream = Assembly.GetExecutingAssembly().GetManifestResourceStream(name)
            ?? throw new FileNotFoundException($"no built-in include '{name}'");
        using StreamReader reader = new(stream);
        return reader.ReadToEnd();
    }

    private static string? Existing(string path) => File.Exists(path) ? Path.GetFullPath(path) : null;
}
