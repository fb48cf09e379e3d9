using System.Globalization;
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
    [TestCase("DuckPond", 0.04, 300, 400)]
    [TestCase("StormInAGlass", 0.04, 300, 400)]
    [TestCase("Gallery", 0.04, 300, 400)]
    [TestCase("Stairs", 0.1, 90)]
    public void TheSamplePlaysWithoutAnErrorAndGetsLiquid(string sample, double seconds, int leastParticles, int given = 0)
    {
        string output = Path.Combine(folder, sample);
        string[] twice = given == 0 ? ["--twice"] : [], few = given == 0 ? [] : ["--", "--particles", $"{given}"];
        PlayerProcess run = PlayerProcess.Run([
            "play", "--project", FuzzProject.Repository, "--assemblies", Path.Combine(FuzzProject.Repository, "Build/ScriptAssemblies"),
            "--executeMethod", "SphFluid.Validation.CommandLine.Play", "--scene", $"Packages/com.sphfluid/Samples~/{sample}/{sample}.unity", "--size", "64x36", "--fps", "30",
            "--seconds", seconds.ToString(CultureInfo.InvariantCulture), "--out", output, .. twice, .. few]);
        if (run.ExitCode != 0) Assert.Fail(run.Output + run.Errors);
        Assert.That(run.Output + run.Errors, Does.Not.Contain("GarbageCollector disposing"), "a buffer that nobody released");
        using JsonDocument summary = JsonDocument.Parse(File.ReadAllText(Path.Combine(output, "summary.json")));
        Assert.That(summary.RootElement.GetProperty("errors").GetInt32(), Is.Zero);
        Assert.That(Particles(summary.RootElement), Is.GreaterThan(leastParticles));
    }

    // A block of 16,380 particles falls on a floor with boxes. Speeds that lists of neighbours go by are four frames old.
    [Test]
    public void DamBreakGainsNoEnergy()
    {
        string output = Path.Combine(folder, "energy"), record = Path.Combine(folder, "energy.csv");
        PlayerProcess run = PlayerProcess.Run([
            "play", "--project", FuzzProject.Repository, "--assemblies", Path.Combine(FuzzProject.Repository, "Build/ScriptAssemblies"),
            "--executeMethod", "SphFluid.Validation.CommandLine.Play", "--scene", "Packages/com.sphfluid/Samples~/DamBreak/DamBreak.unity",
            "--no-images", "--fps", "24", "--seconds", "0.42", "--out", output, "--", "--record", record]);
        if (run.ExitCode != 0) Assert.Fail(run.Output + run.Errors);
        using JsonDocument summary = JsonDocument.Parse(File.ReadAllText(Path.Combine(output, "summary.json")));
        double mass = 1000.0 * Particles(summary.RootElement) * Math.Pow(summary.RootElement.GetProperty("spacing_m").GetDouble(), 3.0);
        string[][] rows = [.. File.ReadAllLines(record).Select(line => line.Split(','))];
        double Number(string[] row, string name) => double.Parse(row[Array.IndexOf(rows[0], name)], CultureInfo.InvariantCulture);
        double Energy(string[] row) => Number(row, "kinetic_energy_j") / mass + 9.81 * Number(row, "centre_y_m");
        double[] gained = [.. rows.Skip(1).Select(row => Energy(row) - Energy(rows[1]))];
        Assert.That(Number(rows[^1], "kinetic_energy_j") / mass, Is.GreaterThan(1.0), "it moves");
        Assert.That(gained.Max(), Is.LessThan(0.01), "J/kg");
        Assert.That(gained[^1], Is.LessThan(-0.3), "what hit the floor has lost some");
    }

    // Of all liquids: a scene with several has a list of them.
    private static int Particles(JsonElement root) => root.TryGetProperty("simulations", out JsonElement several)
        ? several.EnumerateArray().Sum(liquid => liquid.GetProperty("particles").GetInt32())
        : root.GetProperty("particles").GetInt32();
}
