using System.Text.Json;
using Headless.Checks;
using Headless.Checks.Api;
using Headless.Tests.Fuzz;
using NUnit.Framework;

namespace Headless.Tests.Player;

/// <summary>A game that installs the product, alone or with one of the packages that build on it: a project with these, one sample and their script assemblies.</summary>
[Category("Gpu")]
public sealed class ProductAloneTests
{
    private const string Thesis = "Thesis";
    private static readonly string[] packageFolders = ["Runtime", "Shaders", "Editor", "Universal", Thesis];
    private static readonly ProjectPackages packages = new(FuzzProject.Repository);
    private string folder = "";

    [SetUp]
    public void MakeFolder() => folder = Directory.CreateTempSubdirectory("alone-").FullName;

    [TearDown]
    public void Clean() => Directory.Delete(folder, recursive: true);

    [Test]
    public void TheProductPlaysAlone([Values] bool withThesis)
    {
        MakeProject("DamBreak", ProjectPackages.ProductName);
        if (!withThesis)
        {
            Directory.Delete(Path.Combine(folder, "Packages", ProjectPackages.ProductName, Thesis), recursive: true);
            File.Delete(Path.Combine(folder, "Packages", ProjectPackages.ProductName, Thesis + ".meta"));
            File.Delete(Path.Combine(folder, "Assemblies", "SphFluid.Thesis.dll"));
        }
        JsonElement summary = Play("DamBreak", withThesis ? "" : "DefaultFluidShaderSet", "--fps", "30", "--seconds", "0.0334");
        Assert.That(summary.GetProperty("frames").GetInt32(), Is.EqualTo(2));
        Assert.That(summary.TryGetProperty("state_hash", out _), Is.False, "what measures is not there");
        Assert.That(Differences(0, 1), Is.GreaterThan(20), "pixels that change as the water falls");
    }

    // Ten frames are recorded; the eleventh plays the first of them.
    [Test]
    public void ThePlaybackPackagePlaysWhatItRecorded()
    {
        MakeProject("RecordAndPlay", ProjectPackages.ProductName, "com.sphfluid.playback");
        Play("RecordAndPlay", "", "--fps", "10", "--seconds", "1.2");
        Assert.That(Differences(1, 10), Is.GreaterThan(1000), "the water has fallen");
        Assert.That(Differences(1, 11), Is.LessThan(20), "it is where it was");
    }

    [Test]
    public void ThePysphPackageExportsWhatItPlays()
    {
        MakeProject("ExportToPySph", ProjectPackages.ProductName, "com.sphfluid.pysph");
        Play("ExportToPySph", "", "--fps", "30", "--seconds", "0.6");
        string made = Path.GetDirectoryName(Directory.GetFiles(folder, "manifest.json", SearchOption.AllDirectories).Single())!;
        using JsonDocument manifest = JsonDocument.Parse(File.ReadAllText(Path.Combine(made, "manifest.json")));
        Assert.That(manifest.RootElement.GetProperty("liquidParticles").GetInt32(), Is.GreaterThan(1000));
        Assert.That(Directory.GetFiles(made).Select(Path.GetFileName), Is.SupersetOf(new[] { "case.py", "run.sh", "job.sbatch", "to_sequence.py", "liquid.npy", "walls.npy" }));
    }

    [Test]
    public void NoSourceOfTheProductNamesAnotherPackage()
    {
        string[] others = [.. packages.All.Where(p => p != packages.Product).SelectMany(p => PackageAssembly.FindAll(p).Select(a => a.Name).Append(Path.GetFileName(p)))];
        Assert.That(others, Is.SupersetOf(new[] { "SphFluid.Validation", "com.sphfluid.validation", "SphFluid.Playback", "com.sphfluid.playback", "SphFluid.PySph", "com.sphfluid.pysph" }));
        foreach (string file in Directory.EnumerateFiles(packages.Product, "*.*", SearchOption.AllDirectories).Where(f => Path.GetExtension(f) is ".cs" or ".asmdef" or ".hlsl" or ".compute" or ".shader"))
            foreach (string line in File.ReadLines(file).Where(l => !l.Contains("InternalsVisibleTo", StringComparison.Ordinal) && !l.TrimStart().StartsWith("//", StringComparison.Ordinal)))
                Assert.That(others.Where(line.Contains), Is.Empty, $"{file}: {line}");
    }

    // The sample is one of the last package.
    private void MakeProject(string sample, params string[] names)
    {
        string[] roots = [.. names.Select(n => Path.Combine(packages.Folder, n))];
        foreach (string root in roots)
        {
            string copy = Path.Combine(folder, "Packages", Path.GetFileName(root));
            foreach (string part in packageFolders.Where(p => Directory.Exists(Path.Combine(root, p))))
            {
                CopyFolder(Path.Combine(root, part), Path.Combine(copy, part));
                File.Copy(Path.Combine(root, part + ".meta"), Path.Combine(copy, part + ".meta"));
            }
            foreach (string file in new[] { "package.json", "package.json.meta" }) File.Copy(Path.Combine(root, file), Path.Combine(copy, file));
        }
        CopyFolder(Path.Combine(roots[^1], "Samples~", sample), Path.Combine(folder, "Assets", sample));
        File.WriteAllText(Path.Combine(folder, "Assets", sample + ".meta"), $"fileFormatVersion: 2\nguid: {new string('a', 32)}\nfolderAsset: yes\n");
        foreach (string settings in new[] { "ProjectSettings", "Assets/Settings" })
            CopyFolder(Path.Combine(FuzzProject.Repository, settings), Path.Combine(folder, settings));
        File.Copy(Path.Combine(FuzzProject.Repository, "Assets/Settings.meta"), Path.Combine(folder, "Assets/Settings.meta"));
        Directory.CreateDirectory(Path.Combine(folder, "Assemblies"));
        IEnumerable<PackageAssembly> assemblies = [.. roots.SelectMany(PackageAssembly.FindAll), .. PackageAssembly.FindSamples(roots[^1]).Where(a => Path.GetFileName(a.Folder) == sample)];
        foreach (string name in assemblies.Where(a => !a.EditorOnly && !a.IsTest).Select(a => a.Name + ".dll"))
            File.Copy(Path.Combine(FuzzProject.Repository, "Build/ScriptAssemblies", name), Path.Combine(folder, "Assemblies", name));
    }

    // incomplete: an asset whose references are named as missing; empty for none.
    private JsonElement Play(string sample, string incomplete, params string[] flags)
    {
        string output = Path.Combine(folder, "out");
        PlayerProcess run = PlayerProcess.RunIn(folder, [
            "play", "--project", folder, "--assemblies", Path.Combine(folder, "Assemblies"), "--scene", $"Assets/{sample}/{sample}.unity", "--size", "160x90", "--out", output, .. flags]);
        if (run.ExitCode != 0) Assert.Fail(run.Output + run.Errors);
        string[] told = run.Errors.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.That(told.Where(l => incomplete.Length == 0 || !(l.Contains(incomplete) && l.EndsWith("the reference is null.", StringComparison.Ordinal))), Is.Empty);
        using JsonDocument summary = JsonDocument.Parse(File.ReadAllText(Path.Combine(output, "summary.json")));
        Assert.That(summary.RootElement.GetProperty("errors").GetInt32(), Is.Zero);
        return summary.RootElement.Clone();
    }

    private int Differences(int first, int second)
    {
        Picture a = Picture.Read(Path.Combine(folder, $"out/frame_{first:00000}.png")), b = Picture.Read(Path.Combine(folder, $"out/frame_{second:00000}.png"));
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
