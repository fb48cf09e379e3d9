using System.Text.Json;
using Headless.Tests.Fuzz;
using NUnit.Framework;

namespace Headless.Tests.Player;

/// <summary>Samples of the package whose liquid comes, or moves bodies, while they play, and those with scripts of their own.</summary>
[Category("Gpu")]
public sealed class SamplePlayTests
{
    private string folder = "";

    [OneTimeSetUp]
    public void MakeFolder() => folder = Directory.CreateTempSubdirectory("samples-").FullName;

    [OneTimeTearDown]
    public void Clean() => Directory.Delete(folder, recursive: true);

    // Large liquids are played with fewer particles; the others as they are, twice in one process.
    [TestCase("Fountain", 0.1, 500, 700)]
    [TestCase("PourAndFill", 0.1, 80)]
    [TestCase("FloatingCrates", 0.1, 500, 700)]
    [TestCase("WaterWheel", 0.1, 500, 700)]
    [TestCase("HeatedWater", 0.1, 500, 700)]
    [TestCase("GettingStarted", 0.1, 500, 700)]
    [TestCase("WaveTank", 0.1, 500, 700)]
    [TestCase("WeatherProof", 0.17, 250)]
    [TestCase("Liquids", 0.1, 270)]
    [TestCase("Waterfall", 0.04, 300, 400)]
    [TestCase("Harbour", 0.04, 300, 400)]
    [TestCase("StormInAGlass", 0.04, 300, 400)]
    [TestCase("Gallery", 0.04, 300, 400)]
    public void TheSamplePlaysWithoutAnErrorAndGetsLiquid(string sample, double seconds, int leastParticles, int given = 0)
    {
        string output = Path.Combine(folder, sample);
        string[] twice = given == 0 ? ["--twice"] : [], few = given == 0 ? [] : ["--", "--particles", $"{given}"];
        PlayerProcess run = PlayerProcess.Run([
            "play", "--project", FuzzProject.Repository, "--assemblies", Path.Combine(FuzzProject.Repository, "Build/ScriptAssemblies"),
            "--executeMethod", "SphFluid.Validation.CommandLine.Play", "--scene", $"Packages/com.sphfluid/Samples~/{sample}/{sample}.unity", "--size", "64x36", "--fps", "30",
            "--seconds", seconds.ToString(System.Globalization.CultureInfo.InvariantCulture), "--out", output, .. twice, .. few]);
        if (run.ExitCode != 0) Assert.Fail(run.Output + run.Errors);
        Assert.That(run.Output + run.Errors, Does.Not.Contain("GarbageCollector disposing"), "a buffer that nobody released");
        using JsonDocument summary = JsonDocument.Parse(File.ReadAllText(Path.Combine(output, "summary.json")));
        Assert.That(summary.RootElement.GetProperty("errors").GetInt32(), Is.Zero);
        Assert.That(Particles(summary.RootElement), Is.GreaterThan(leastParticles));
    }

    // Of all liquids: a scene with several has a list of them.
    private static int Particles(JsonElement root) => root.TryGetProperty("simulations", out JsonElement several)
        ? several.EnumerateArray().Sum(liquid => liquid.GetProperty("particles").GetInt32())
        : root.GetProperty("particles").GetInt32();
}
