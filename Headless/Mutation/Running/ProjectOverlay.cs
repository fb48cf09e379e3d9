namespace Headless.Mutation.Running;

/// <summary>
/// A Unity project that is another one by links, but for its package's shaders, which are copies and may be changed, and for
/// one script assembly. The project itself is never written to.
/// </summary>
internal sealed class ProjectOverlay
{
    private const string PackagePath = "Packages/com.sphfluid";
    private readonly string source, built;

    public ProjectOverlay(string source, string assemblies, string folder)
    {
        this.source = source;
        built = assemblies;
        Project = Path.Combine(folder, "project");
        Assemblies = Path.Combine(folder, "assemblies");
        foreach (string old in new[] { Project, Assemblies })
            if (Directory.Exists(old)) Directory.Delete(old, recursive: true);
        Link(source, Project, ["Packages"], ["Assets", "ProjectSettings"]);
        Link(Path.Combine(source, "Packages"), Path.Combine(Project, "Packages"), ["com.sphfluid"]);
        Link(Path.Combine(source, PackagePath), Package, ["Shaders", "Thesis"]);
        Link(Path.Combine(source, PackagePath, "Thesis"), Path.Combine(Package, "Thesis"), ["Shaders"]);
        foreach (string shaders in new[] { "Shaders", "Thesis/Shaders" }.Where(s => Directory.Exists(Path.Combine(source, PackagePath, s))))
        {
            foreach (string file in Directory.EnumerateFiles(Path.Combine(source, PackagePath, shaders), "*", SearchOption.AllDirectories))
            {
                string copy = Path.Combine(Package, Path.GetRelativePath(Path.Combine(source, PackagePath), file));
                Directory.CreateDirectory(Path.GetDirectoryName(copy)!);
                File.Copy(file, copy);
            }
        }

        Directory.CreateDirectory(Assemblies);
        foreach (string file in Directory.EnumerateFiles(assemblies, "*.dll")) File.Copy(file, Path.Combine(Assemblies, Path.GetFileName(file)));
    }

    public string Source => source;
    public string Project { get; }
    public string Assemblies { get; }
    public string Package => Path.Combine(Project, PackagePath);

    public bool Has(string file) => File.Exists(Path.Combine(source, PackagePath, file));

    public string Original(string file) => File.ReadAllText(Path.Combine(source, PackagePath, file));

    public void WriteShader(string file, string text) => File.WriteAllText(Path.Combine(Package, file), text);

    public void RestoreShader(string file) => WriteShader(file, Original(file));

    public void WriteAssembly(string name, byte[] bytes) => File.WriteAllBytes(Path.Combine(Assemblies, name + ".dll"), bytes);

    public void RestoreAssembly(string name) => File.Copy(Path.Combine(built, name + ".dll"), Path.Combine(Assemblies, name + ".dll"), overwrite: true);

    // Everything in a folder but the entries that the overlay has itself.
    private static void Link(string from, string to, IReadOnlyCollection<string> but, IReadOnlyCollection<string>? only = null)
    {
        if (!Directory.Exists(from)) return;
        Directory.CreateDirectory(to);
        foreach (string entry in Directory.EnumerateFileSystemEntries(from))
        {
            string name = Path.GetFileName(entry);
            if (but.Contains(name) || (only is not null && !only.Contains(name))) continue;
            if (Directory.Exists(entry)) Directory.CreateSymbolicLink(Path.Combine(to, name), entry);
            else File.CreateSymbolicLink(Path.Combine(to, name), entry);
        }
    }
}
