using Headless.Checks;

namespace Headless.Tests.Checks;

/// <summary>A Unity project with a small package in a folder of its own.</summary>
internal sealed class TemporaryPackage : IDisposable
{
    public string Project { get; } = Directory.CreateTempSubdirectory("package").FullName;
    public string Root => Path.Combine(Project, "Packages", ProjectPackages.ProductName);
    public ProjectPackages Packages => new(Project);

    public TemporaryPackage()
    {
        Directory.CreateDirectory(Path.Combine(Root, "Runtime"));
        Write("Runtime/A.asmdef", """{ "name": "A", "references": [], "includePlatforms": [], "defineConstraints": [] }""");
    }

    public TemporaryPackage Write(string path, string text)
    {
        var file = Path.Combine(Root, path);
        Directory.CreateDirectory(Path.GetDirectoryName(file)!);
        File.WriteAllText(file, text);
        return this;
    }

    public TemporaryPackage WriteMeta(string path, string guid) => Write(path + ".meta", $"fileFormatVersion: 2\nguid: {guid}\n");

    public void Dispose() => Directory.Delete(Project, recursive: true);
}
