using System.Diagnostics;
using Headless.Player;
using Headless.Player.Output;
using Headless.Tests.Fuzz;
using NUnit.Framework;

namespace Headless.Tests.Player;

/// <summary>The real process where it must not, or cannot, write: one line, an exit code, and files as they were.</summary>
[Category("Gpu")]
[Platform(Exclude = "Win")]
public sealed class OutputContractTests
{
    private string folder = "";

    [SetUp]
    public void SetUp() => folder = Directory.CreateTempSubdirectory("contract-").FullName;

    [TearDown]
    public void TearDown() => Directory.Delete(folder, recursive: true);

    private string Out => Path.Combine(folder, "out");

    private string[] DamBreak(params string[] more)
    {
        string root = FuzzProject.Repository;
        return
        [
            "play", "--project", root, "--assemblies", Path.Combine(root, "Build/ScriptAssemblies"), "--executeMethod", "SphFluid.Validation.CommandLine.Play",
            "--scene", "Packages/com.sphfluid/Samples~/DamBreak/DamBreak.unity", "--size", "64x36", "--out", Out, "--", "--surface", "none", .. more,
        ];
    }

    /// <summary>What the package's parser refuses, and what is refused when the liquid starts.</summary>
    [TestCase(2, "play: --method must be one of", "--method", "nope")]
    [TestCase(1, "play: no liquid is left to play", "--particles", "1", "--state", "STATE")]
    public void ARefusedCommandChangesNoFile(int code, string line, params string[] words)
    {
        Directory.CreateDirectory(Out);
        string state = Path.Combine(folder, "state.ply");
        foreach (string name in new[] { "frame_00000.png", "film.mp4", "summary.json", "timings.csv" }) File.WriteAllText(Path.Combine(Out, name), name);
        File.WriteAllLines(Path.Combine(Out, OutputFolder.ListName), ["frame_00000.png", "film.mp4", "summary.json", "timings.csv"]);
        File.WriteAllText(state, "earlier");
        Dictionary<string, string> before = Contents();
        PlayerProcess run = PlayerProcess.Run(DamBreak([.. words.Select(w => w == "STATE" ? state : w)]));
        Assert.That(run.ExitCode, Is.EqualTo(code), run.Output + run.Errors);
        Assert.That(run.Errors, Does.Contain(line).And.Not.Contain("   at "));
        Assert.That(Contents(), Is.EqualTo(before));
    }

    [Test]
    public void AFolderInUseIsRefusedUntilItsRunIsDead()
    {
        using Process first = PlayerProcess.Start(DamBreak("--particles", "600"));
        for (int i = 0; i < 600 && !first.HasExited && !File.Exists(Path.Combine(Out, OutputFolder.LockName)); i++) Thread.Sleep(50);
        PlayerProcess second = PlayerProcess.Run(DamBreak());
        bool running = !first.HasExited;
        first.Kill(entireProcessTree: true);
        first.WaitForExit();
        Assert.That(running, Is.True, "else nothing was tested");
        Assert.That((second.ExitCode, second.Errors), Is.EqualTo((2, $"sphplayer: --out: another run writes to '{Out}'. Wait for its end, or name another folder.\n")));
        Assert.That(() => OutputFolder.Open(Out, 1, film: true).Dispose(), Throws.Nothing);
    }

    [Test]
    public void AQuestionWithoutAnAnswerEndsWithOne()
    {
        string root = FuzzProject.Repository;
        PlayerProcess run = PlayerProcess.Run("exec", "--project", root, "--assemblies", Path.Combine(root, "Build/ScriptAssemblies"), "--executeMethod", "SphFluid.Validation.CommandLine.Choose",
            "--", "--chart", Path.Combine(root, "benchmarks/accuracy/llvmpipe-2026-11-25"), "--case", "ellipsoid", "--ms", "0.000001", "--out", Out);
        Assert.That(run.ExitCode, Is.EqualTo(1), run.Output + run.Errors);
        Assert.That(run.Errors, Does.StartWith("choose: nothing that was measured keeps what was asked"));
        Assert.That(run.Output, Does.Contain("Nothing that was measured keeps"));
        Assert.That(Path.Combine(Out, "choose.csv"), Does.Exist);
    }

    [TestCase("> /dev/full", 1, "sphplayer: standard output cannot be written, so lines are missing: ")]
    [TestCase("> /dev/full 2> /dev/full", 1, "")]
    [TestCase("2> /dev/full", 0, "")]
    public void AFullOutputIsALineAndAnExitCode(string redirected, int code, string line)
    {
        PlayerProcess run = Shell($"exec dotnet {Program} devices {redirected}");
        Assert.That(run.ExitCode, Is.EqualTo(code));
        Assert.That(run.Errors, line.Length == 0 ? Is.Empty : Does.StartWith(line).And.EndsWith("\n"));
        Assert.That(run.Errors.Count(c => c == '\n'), Is.LessThanOrEqualTo(1));
    }

    [TestCase("XDG_CACHE_HOME=/dev/null", "sphplayer: the cache folder '/dev/null/sphplayer' cannot be written, so shaders are compiled in each run: ")]
    [TestCase("XDG_CACHE_HOME=/proc", "sphplayer: the cache folder '/proc/sphplayer' cannot be written")]
    public void ACacheThatCannotBeWrittenIsDoneWithout(string setting, string line)
    {
        PlayerProcess run = Shell($"{setting} exec dotnet {Program} devices");
        Assert.That(run.ExitCode, Is.Zero, run.Errors);
        Assert.That(run.Output, Is.Not.Empty);
        Assert.That(run.Errors, Does.StartWith(line));
        Assert.That(run.Errors.Count(c => c == '\n'), Is.EqualTo(1));
    }

    private static string Program => $"'{Path.Combine(AppContext.BaseDirectory, "sphplayer.dll")}'";

    private static PlayerProcess Shell(string command)
    {
        using Process process = Process.Start(new ProcessStartInfo("bash", ["-c", command]) { RedirectStandardOutput = true, RedirectStandardError = true })!;
        return PlayerProcess.Finish(process);
    }

    private Dictionary<string, string> Contents() => Directory.GetFiles(folder, "*", SearchOption.AllDirectories).ToDictionary(f => f, File.ReadAllText);
}
