using System.Diagnostics;
using System.Globalization;
using Headless.Tests.Fuzz;
using NUnit.Framework;

namespace Headless.Tests.Player;

/// <summary>
/// A long play takes no more memory than a short one; the judge is the process. SPHFLUID_LONG_PLAY=2000 draws that many frames, of three samples.
/// </summary>
[Category("Gpu")]
public sealed class LongPlayTests
{
    private const int WarmUp = 150, FrameRate = 500;

    // Bytes, in hexadecimal: the managed heap collects its youngest objects each MiB, so that it is as large after the warm-up as it gets.
    private const string YoungestObjects = "100000";
    private const double MostKiBPerFrame = 20;

    private static readonly int Frames = int.Parse(Environment.GetEnvironmentVariable("SPHFLUID_LONG_PLAY") ?? "300", CultureInfo.InvariantCulture);

    // Water and whitewater; then water with emitters and drains, and water beside opaque liquids.
    private static IEnumerable<string> Samples() => Frames < 1000 ? ["DamBreak"] : ["DamBreak", "Fountain", "Liquids"];

    [TestCaseSource(nameof(Samples))]
    public void EveryFrameGivesItsMemoryBack(string sample)
    {
        string folder = Directory.CreateTempSubdirectory("long-play-").FullName;
        try
        {
            string[] few = sample == "Liquids" ? [] : ["--", "--particles", "300"];
            Environment.SetEnvironmentVariable("DOTNET_GCgen0size", YoungestObjects);
            using Process process = PlayerProcess.Start([
                "play", "--project", FuzzProject.Repository, "--assemblies", Path.Combine(FuzzProject.Repository, "Build/ScriptAssemblies"),
                "--executeMethod", "SphFluid.Validation.CommandLine.Play", "--scene", $"Packages/com.sphfluid/Samples~/{sample}/{sample}.unity", "--size", "32x18",
                "--fps", $"{FrameRate}", "--seconds", (Frames / (double)FrameRate).ToString(CultureInfo.InvariantCulture), "--out", folder, .. few]);
            Task<PlayerProcess> run = Task.Run(() => PlayerProcess.Finish(process, TimeSpan.FromHours(1)));
            List<(double Frame, double KiB)> memory = Watch(process, folder);
            Assert.That(run.Result.ExitCode, Is.Zero, run.Result.Output + run.Result.Errors);
            Assert.That(memory, Has.Count.EqualTo(Frames - WarmUp));
            double slope = Slope(memory);
            TestContext.Out.WriteLine(FormattableString.Invariant($"{sample}: {slope:0.0} KiB a frame, {memory[0].KiB / 1024:0} to {memory[^1].KiB / 1024:0} MiB"));
            Assert.That(slope, Is.LessThan(MostKiBPerFrame), "KiB of the process a frame");
        }
        finally
        {
            Environment.SetEnvironmentVariable("DOTNET_GCgen0size", null);
            Directory.Delete(folder, recursive: true);
        }
    }

    /// <summary>The resident memory of the process each time another frame is on the disk.</summary>
    private static List<(double Frame, double KiB)> Watch(Process process, string folder)
    {
        List<(double, double)> memory = [];
        for (int frame = 0; frame < Frames && !process.HasExited;)
        {
            if (!File.Exists(Path.Combine(folder, $"frame_{frame:D5}.png")))
            {
                Thread.Sleep(10);
                continue;
            }
            process.Refresh();
            if (frame++ >= WarmUp) memory.Add((frame, process.WorkingSet64 / 1024.0));
        }
        return memory;
    }

    private static double Slope(List<(double X, double Y)> points)
    {
        (double x, double y) = (points.Average(p => p.X), points.Average(p => p.Y));
        return points.Sum(p => (p.X - x) * (p.Y - y)) / points.Sum(p => (p.X - x) * (p.X - x));
    }
}
