using System.Text.Json;
using System.Text.RegularExpressions;
using Headless.Bench.Scene;
using Headless.Tests.Fuzz;
using NUnit.Framework;

namespace Headless.Tests.Player;

/// <summary>What the page "Output files" says of a play's files, against those that a short play writes.</summary>
[Category("Gpu")]
public sealed partial class DocumentedOutputTests
{
    private static readonly string Page = File.ReadAllText(
        Path.Combine(FuzzProject.Repository, "Packages/com.sphfluid.validation/Documentation~/output-files.md")).ReplaceLineEndings("\n");

    private string folder = "";

    [OneTimeSetUp]
    public void Play()
    {
        folder = Directory.CreateTempSubdirectory("documented-").FullName;
        PlayerProcess run = PlayerProcess.Run([.. Words(folder), "--",
            "--particles", "1000", "--state", Path.Combine(folder, "state.ply"), "--mesh", Path.Combine(folder, "mesh.ply"), "--write-sequence", Path.Combine(folder, "sequence")]);
        if (run.ExitCode != 0) Assert.Fail(run.Output + run.Errors);
    }

    private static string[] Words(string output) =>
    [
        "play", "--project", FuzzProject.Repository, "--assemblies", Path.Combine(FuzzProject.Repository, "Build/ScriptAssemblies"),
        "--executeMethod", "SphFluid.Validation.CommandLine.Play", "--scene", "Packages/com.sphfluid/Samples~/DamBreak/DamBreak.unity",
        "--size", "64x36", "--fps", "30", "--seconds", "0.1", "--out", output,
    ];

    [OneTimeTearDown]
    public void Clean() => Directory.Delete(folder, recursive: true);

    [Test]
    public void TimingsHaveTheColumnsOfThePage()
    {
        string[] written = [.. File.ReadLines(Path.Combine(folder, "timings.csv")).First().Split(',')];
        Assert.That(written.Select(c => c.StartsWith("gpu_ms.", StringComparison.Ordinal) ? "gpu_ms.PASS" : c).Distinct(), Is.EqualTo(Names("timings.csv")));
        Assert.That(written, Contains.Item("gpu_ms.StandardDensity"), "the page's example");
    }

    [Test]
    public void TheSummaryHasTheKeysOfThePage()
    {
        using JsonDocument summary = JsonDocument.Parse(File.ReadAllText(Path.Combine(folder, "summary.json")));
        IEnumerable<string> keys = summary.RootElement.EnumerateObject().Select(p => p.Name);
        IEnumerable<string> caps = summary.RootElement.GetProperty("cap_hits").EnumerateObject().Select(p => p.Name);
        // The scene's method is not Automatic, and its liquid is not played from files.
        Assert.That(keys.Concat(caps), Is.EqualTo(Names("summary.json").Where(n => n is not ("method_choice" or "sequence"))));
    }

    [Test]
    public void ASequenceIsPlayedAndSaidSoInTheSummary()
    {
        string played = Path.Combine(folder, "played");
        PlayerProcess run = PlayerProcess.Run([.. Words(played), "--no-images", "--", "--sequence", Path.Combine(folder, "sequence"), "--surface", "none"]);
        Assert.That(run.ExitCode, Is.Zero, run.Output + run.Errors);
        using JsonDocument summary = JsonDocument.Parse(File.ReadAllText(Path.Combine(played, "summary.json")));
        JsonElement sequence = summary.RootElement.GetProperty("sequence");
        Assert.That(sequence.EnumerateObject().Select(p => p.Name), Is.EqualTo(new[] { "source", "frames", "frame", "left_out_particles", "memory_bytes" }));
        using JsonDocument simulated = JsonDocument.Parse(File.ReadAllText(Path.Combine(folder, "summary.json")));
        Assert.That(summary.RootElement.GetProperty("particles").GetInt32(), Is.EqualTo(simulated.RootElement.GetProperty("particles").GetInt32()));
        Assert.That(summary.RootElement.GetProperty("steps").GetInt32(), Is.EqualTo(sequence.GetProperty("frames").GetInt32()), "a frame of the sequence for each of the scene");
    }

    [TestCase("State", "state.ply")]
    [TestCase("Mesh", "mesh.ply")]
    public void APlyHasThePropertiesOfThePage(string heading, string file)
    {
        // What follows the header are bytes.
        string header = File.ReadAllText(Path.Combine(folder, file), System.Text.Encoding.Latin1).Split("end_header")[0];
        Assert.That(Property().Matches(header).Select(m => m.Groups[1].Value), Is.EqualTo(Names(heading)));
        foreach (Match row in TypedRow().Matches(Section(heading)))
            foreach (string name in Code().Matches(row.Groups[1].Value).Select(m => m.Groups[1].Value))
                Assert.That(header, Does.Match($@"\nproperty {(row.Groups[2].Value == "list of int" ? "list uchar int" : row.Groups[2].Value)} {name}\n"));
    }

    [Test]
    public void PicturesAndFilmHaveTheNamesOfThePage()
    {
        string[] named = [.. Code().Matches(Section("Pictures and film")).Select(m => m.Groups[1].Value).Where(n => n.EndsWith(".png", StringComparison.Ordinal) || n.EndsWith(".mp4", StringComparison.Ordinal))];
        Assert.That(named, Has.Length.EqualTo(3));
        foreach (string name in named) Assert.That(Path.Combine(folder, name), Does.Exist);
    }

    [TestCase("scene.csv", SceneTable.Head)]
    [TestCase("scene-frames.csv", SceneTable.FramesHead + "ms.PASS,times.PASS")]
    public void TheTableOfScenesHasTheColumnsOfThePage(string heading, string head) => Assert.That(head.Split(','), Is.EqualTo(Names(heading)));

    private static string Section(string heading) => Regex.Match(Page, $@"^## {Regex.Escape(heading)}\n([\s\S]*?)(?=^## |\z)", RegexOptions.Multiline).Groups[1].Value;

    private static string[] Names(string heading) =>
        [.. Row().Matches(Section(heading)).SelectMany(r => Code().Matches(r.Groups[1].Value)).Select(m => m.Groups[1].Value)];

    [GeneratedRegex(@"^\| (`[^|]*)\|", RegexOptions.Multiline)] private static partial Regex Row();
    [GeneratedRegex(@"^\| (`[^|]*)\| ([a-z ]+) \|", RegexOptions.Multiline)] private static partial Regex TypedRow();
    [GeneratedRegex("`([^`]+)`")] private static partial Regex Code();
    [GeneratedRegex(@"^property .* (\w+)\s*$", RegexOptions.Multiline)] private static partial Regex Property();
}
