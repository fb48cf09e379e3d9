using System.Text.Json;
using Headless.Checks;
using Headless.Tests.Fuzz;
using NUnit.Framework;

namespace Headless.Tests.Player;

/// <summary>A game that installs com.sphfluid and nothing else: a project with that package, one sample and its one script assembly.</summary>
[Category("Gpu")]
public sealed class ProductAloneTests
{
    private const string Scene = "Assets/DamBreak/DamBreak.unity", Assembly = "SphFluid.dll";
    private static readonly string[] packageFolders = ["Runtime", "Shaders", "Editor", "Universal"];
    private string folder = "";

    [OneTimeSetUp]
    public void MakeProject()
    {
        folder = Directory.CreateTempSubdirectory("alone-").FullName;
        string product = new ProjectPackages(FuzzProject.Repository).Product, copy = Path.Combine(folder, "Packages", ProjectPackages.ProductName);
        foreach (string part in packageFolders)
        {
            CopyFolder(Path.Combine(product, part), Path.Combine(copy, part));
            File.Copy(Path.Combine(product, part + ".meta"), Path.Combine(copy, part + ".meta"));
        }
        foreach (string file in new[] { "package.json", "package.json.meta" }) File.Copy(Path.Combine(product, file), Path.Combine(copy, file));
        CopyFolder(Path.Combine(product, "Samples~/DamBreak"), Path.Combine(folder, "Assets/DamBreak"));
        File.WriteAllText(Path.Combine(folder, "Assets/DamBreak.meta"), $"fileFormatVersion: 2\nguid: {new string('a', 32)}\nfolderAsset: yes\n");
        CopyFolder(Path.Combine(FuzzProject.Repository, "ProjectSettings"), Path.Combine(folder, "ProjectSettings"));
        Directory.CreateDirectory(Path.Combine(folder, "Assemblies"));
        File.Copy(Path.Combine(FuzzProject.Repository, "Build/ScriptAssemblies", Assembly), Path.Combine(folder, "Assemblies", Assembly));
    }

    [OneTimeTearDown]
    public void Clean() => Directory.Delete(folder, recursive: true);

    [Test]
    public void TheSamplePlaysWithoutTheValidationPackage()
    {
        string output = Path.Combine(folder, "out");
        PlayerProcess run = PlayerProcess.Run(
            "play", "--project", folder, "--assemblies", Path.Combine(folder, "Assemblies"), "--scene", Scene,
            "--size", "160x90", "--fps", "30", "--seconds", "0.0334", "--out", output);
        if (run.ExitCode != 0) Assert.Fail(run.Output + run.Errors);
        Assert.That(run.Errors, Is.Empty);
        using JsonDocument summary = JsonDocument.Parse(File.ReadAllText(Path.Combine(output, "summary.json")));
        Assert.That(summary.RootElement.GetProperty("frames").GetInt32(), Is.EqualTo(2));
        Assert.That(summary.RootElement.GetProperty("errors").GetInt32(), Is.Zero);
        Assert.That(summary.RootElement.TryGetProperty("state_hash", out _), Is.False, "what measures is not there");
        Picture first = Picture.Read(Path.Combine(output, "frame_00000.png")), second = Picture.Read(Path.Combine(output, "frame_00001.png"));
        Assert.That(Differences(first, second), Is.GreaterThan(20), "pixels that change as the water falls");
    }

    [Test]
    public void NoSourceOfTheProductNamesTheValidationPackage()
    {
        string product = new ProjectPackages(FuzzProject.Repository).Product;
        foreach (string file in Directory.EnumerateFiles(product, "*.*", SearchOption.AllDirectories).Where(f => Path.GetExtension(f) is ".cs" or ".asmdef" or ".hlsl" or ".compute" or ".shader"))
            foreach (string line in File.ReadLines(file).Where(l => !l.Contains("InternalsVisibleTo", StringComparison.Ordinal) && !l.TrimStart().StartsWith("//", StringComparison.Ordinal)))
                Assert.That(line, Does.Not.Contain("SphFluid.Validation").And.Not.Contain("com.sphfluid.validation"), file);
    }

    private static int Differences(Picture a, Picture b)
    {
        int count = 0;
        for (int y = 0; y < a.Height; y++)
            for (int x = 0; x < a.Width; x++)
                if (a[x, y] != b[x, y]) count++;
        return count;
    }

    private static void CopyFolder(string from, string to)
    {
        foreach (string file in Directory.EnumerateFiles(from, "*", SearchOption.AllDirectories))
        {
            string target = Path.Combine(to, Path.GetRelativePath(from, file));
            Directory.CreateDirectory(Path.GetDirectoryName(target)!);
            File.Copy(file, target);
        }
    }
}
