using System.Diagnostics;
using System.Globalization;
using System.Text.RegularExpressions;
using Headless.Tests.Fuzz;
using Headless.Tests.Player;
using NUnit.Framework;

namespace Headless.Tests.Card;

/// <summary>The player on a card that is not there, whose times come from a model: card_layer.c.</summary>
[Category("Gpu")]
[Platform("Linux")]
public sealed partial class CardTests
{
    private string folder = "", layer = "";

    [OneTimeSetUp]
    public void BuildTheLayer()
    {
        layer = Path.Combine(FuzzProject.Repository, "Build/card-of-tests");
        using Process build = Process.Start(
            new ProcessStartInfo("bash", [Path.Combine(FuzzProject.Repository, "Headless/Tests/Card/build.sh"), layer]) { RedirectStandardError = true })!;
        string errors = build.StandardError.ReadToEnd();
        build.WaitForExit();
        Assert.That(build.ExitCode, Is.Zero, errors);
    }

    [SetUp]
    public void SetUp() => folder = Directory.CreateTempSubdirectory("card-").FullName;

    [TearDown]
    public void TearDown() => Directory.Delete(folder, recursive: true);

    // A dispatch takes 40 µs and the queue waits 5 ms for each submission. Frames of the thesis's method come in several.
    [Test]
    public void TimesOfTheTableAreThoseOfItsDispatchesOnACardThatHoldsItsSmallestSizeAlone()
    {
        const double Dispatch = 0.04;
        PlayerProcess run = Run(
            [("CARD_MEMORY_MIB", "260"), ("CARD_DISPATCH_NS", "40000"), ("CARD_IDLE_NS", "5000000")],
            "exec", "--executeMethod", "SphFluid.Validation.CommandLine.Bench", "--", "--table", "solver", "--out", folder);
        Assert.That(run.ExitCode, Is.Zero, run.Output + run.Errors);
        string[][] rows = [.. File.ReadAllLines(Path.Combine(folder, "solver.csv")).Select(line => line.Split(','))];
        double Number(string[] row, string name) => double.Parse(row[Array.IndexOf(rows[0], name)], CultureInfo.InvariantCulture);
        Assert.That(rows, Has.Length.EqualTo(15));
        foreach (string[] row in rows.Skip(1))
        {
            string text = string.Join(',', row);
            Assert.That(Number(row, "particles"), Is.EqualTo(16384), text);
            double modelled = Dispatch * Number(row, "dispatches");
            // Samples of Robust differ by a dispatch or two: one begins with lists that serve on, another sorts.
            double slack = row.Contains("robust") ? 2 * Dispatch : 0.01 * modelled;
            foreach (string time in new[] { "gpu_ms_min", "gpu_ms_median", "gpu_ms_max", "gpu_ms_stamped" })
                Assert.That(Number(row, time), Is.EqualTo(modelled).Within(slack), $"{time}: {text}");
        }

        Assert.That(run.Output + run.Errors, Does.Match(@"left out for want of memory: 65,536 \(.*262,144 \(.*1,048,576 \(.*4,194,304 \(.*Imitated card has"));
    }

    // Each submission of a frame begins 0.9 s after the one before it.
    [Test]
    public void FramesOfAPlayTakeWhatTheQueueWasBusy()
    {
        PlayerProcess run = Run(
            [("CARD_DISPATCH_NS", "2500"), ("CARD_GROUP_NS", "320"), ("CARD_STAMP_NS", "100"), ("CARD_IDLE_NS", "900000000")],
            "play", "--scene", Path.Combine(FuzzProject.Repository, "Packages/com.sphfluid/Samples~/DamBreak/DamBreak.unity"),
            "--seconds", "0.1", "--no-images", "--out", folder);
        Assert.That(run.ExitCode, Is.Zero, run.Output + run.Errors);
        double busy = double.Parse(Sum().Match(run.Errors).Groups[1].Value, CultureInfo.InvariantCulture) * 1e-6;
        string[][] rows = [.. File.ReadAllLines(Path.Combine(folder, "timings.csv")).Select(line => line.Split(','))];
        int column = Array.IndexOf(rows[0], "gpu_ms");
        double frames = rows.Skip(1).Sum(row => double.Parse(row[column], CultureInfo.InvariantCulture));
        Assert.That(frames, Is.InRange(0.5 * busy, 1.001 * busy), "what is done before the first frame is in none");
    }

    private PlayerProcess Run((string, string)[] card, string verb, params string[] words)
    {
        string root = FuzzProject.Repository;
        return PlayerProcess.RunWith(
            [("VK_LAYER_PATH", layer), ("VK_INSTANCE_LAYERS", "VK_LAYER_SPHFLUID_card"), .. card],
            [verb, "--project", root, "--assemblies", Path.Combine(root, "Build/ScriptAssemblies"), .. words]);
    }

    [GeneratedRegex(@"\[card\].* (\d+) ns in all")]
    private static partial Regex Sum();
}
