using System.Diagnostics;
using System.Globalization;
using System.Runtime.InteropServices;
using System.Text.Json;
using Headless.Player.Output;
using Headless.Tests.Fuzz;
using NUnit.Framework;

namespace Headless.Tests.Player;

/// <summary>SIGINT and SIGTERM to the real process in different phases: exit code 130, soon, files whole.</summary>
[Category("Gpu")]
[Platform(Exclude = "Win")]
public sealed class InterruptionTests
{
    private const int Interrupt = 2, Terminate = 15;

    /// <summary>A second on a quiet machine; tests run beside others.</summary>
    private static readonly TimeSpan Bound = TimeSpan.FromSeconds(15);

    private string folder = "";

    [SetUp]
    public void SetUp() => folder = Directory.CreateTempSubdirectory("interrupted-").FullName;

    [TearDown]
    public void TearDown() => Directory.Delete(folder, recursive: true);

    private string[] DamBreak(params string[] more)
    {
        string root = FuzzProject.Repository;
        return
        [
            "play", "--project", root, "--assemblies", Path.Combine(root, "Build/ScriptAssemblies"), "--executeMethod", "SphFluid.Validation.CommandLine.Play",
            "--scene", "Packages/com.sphfluid/Samples~/DamBreak/DamBreak.unity", "--size", "160x90", "--seconds", "600", "--out", folder, .. more,
        ];
    }

    [TestCase(0.05, Interrupt)]
    [TestCase(0.4, Terminate)]
    [TestCase(1.5, Interrupt)]
    public void AtAnyTimeAfterTheStart(double seconds, int signal)
    {
        using Process process = PlayerProcess.Start(DamBreak());
        // The runtime itself answers signals until the player has begun.
        WaitFor(process, () => Directory.GetFiles(folder).Length > 0 || seconds < 1);
        Thread.Sleep(TimeSpan.FromSeconds(seconds));
        End(process, signal);
    }

    [Test]
    public void BetweenFrames()
    {
        using Process process = PlayerProcess.Start(DamBreak("--", "--particles", "300"));
        WaitFor(process, () => File.Exists(Path.Combine(folder, FrameWriter.Name(3))));
        PlayerProcess ended = End(process, Interrupt);
        Assert.That(ended.Output, Does.Contain("interrupted: "));
        CheckFiles(film: true);
    }

    [Test]
    public void WithinAFrameThatTakesMinutes()
    {
        using Process process = PlayerProcess.Start(DamBreak("--fps", "0.01", "--", "--particles", "60000"));
        WaitFor(process, () => File.Exists(Path.Combine(folder, OutputFolder.LockName)));
        Thread.Sleep(TimeSpan.FromSeconds(3));
        End(process, Interrupt);
        CheckFiles(film: false);
    }

    private static void WaitFor(Process process, Func<bool> condition)
    {
        for (int i = 0; i < 1800 && !process.HasExited && !condition(); i++) Thread.Sleep(100);
    }

    private static PlayerProcess End(Process process, int signal)
    {
        Assert.That(process.HasExited, Is.False, () => PlayerProcess.Finish(process).Errors);
        var clock = Stopwatch.StartNew();
        Assert.That(Kill(process.Id, signal), Is.Zero);
        PlayerProcess ended = PlayerProcess.Finish(process, 4 * Bound);
        TestContext.Out.WriteLine(string.Create(CultureInfo.InvariantCulture, $"ended after {clock.Elapsed.TotalSeconds:0.00} s"));
        Assert.That(clock.Elapsed, Is.LessThan(Bound));
        Assert.That(ended.ExitCode, Is.EqualTo(130).Or.EqualTo(128 + signal), ended.Errors);
        Assert.That(ended.Errors, Does.Not.Contain("   at "));
        return ended;
    }

    private void CheckFiles(bool film)
    {
        string[] frames = Directory.GetFiles(folder, "frame_*.png");
        foreach (string frame in frames) Assert.That(Picture.Read(frame).Width, Is.EqualTo(160));
        using JsonDocument summary = JsonDocument.Parse(File.ReadAllText(Path.Combine(folder, SummaryFile.FileName)));
        Assert.That(summary.RootElement.GetProperty("interrupted").GetBoolean(), Is.True);
        Assert.That(summary.RootElement.GetProperty("frames").GetInt32(), Is.EqualTo(frames.Length));
        string[] rows = File.ReadAllLines(Path.Combine(folder, TimingsFile.FileName));
        Assert.That(rows.Select(r => r.Count(c => c == ',')).Distinct().Count(), Is.EqualTo(1), "whole lines");
        Assert.That(Directory.GetFiles(folder, "*.part").Where(f => !f.EndsWith("film.mp4.part", StringComparison.Ordinal)), Is.Empty);
        if (film && File.Exists("/usr/bin/ffmpeg")) Assert.That(File.Exists(Path.Combine(folder, Film.FileName)), Is.True);
    }

    [DllImport("libc", EntryPoint = "kill")]
    private static extern int Kill(int process, int signal);
}
