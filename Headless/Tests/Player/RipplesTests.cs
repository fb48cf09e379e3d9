using System.Diagnostics;
using System.Globalization;
using System.Runtime.InteropServices;
using System.Text.Json;
using NUnit.Framework;

namespace Headless.Tests.Player;

/// <summary>Plays a small project of someone else's: a wave equation in two kernels, a shader, a prefab, a model. No fluid in it.</summary>
[Category("Gpu")]
public sealed class RipplesTests
{
    private const int Width = 384, Height = 256, Frames = 11;
    private const float PixelsPerUnit = Height / 2f;
    private string folder = "";
    private PlayerProcess run = null!;

    private static readonly string Project = Path.Combine(PlayerProcess.ProjectsFolder, "Ripples");
    private static string[] Arguments(string output, params string[] more) =>
    [
        "play", "--project", Project, "--assemblies", PlayerProcess.AssembliesOf("Ripples"), "--scene", "Assets/Scenes/Ripples.unity",
        "--size", $"{Width}x{Height}", "--fps", "30", "--out", output, .. more,
    ];

    [OneTimeSetUp]
    public void Play()
    {
        folder = Directory.CreateTempSubdirectory("ripples-").FullName;
        run = PlayerProcess.Run(Arguments(folder, "--seconds", ((Frames - 1) / 30.0).ToString(CultureInfo.InvariantCulture)));
        if (run.ExitCode != 0) Assert.Fail(run.Output + run.Errors);
    }

    [OneTimeTearDown]
    public void Clean() => Directory.Delete(folder, recursive: true);

    private Picture Frame(int number) => Picture.Read(Path.Combine(folder, $"frame_{number:D5}.png"));

    private static (int R, int G, int B) At(Picture picture, float x, float y) =>
        picture[(int)(Width / 2f + x * PixelsPerUnit), (int)(Height / 2f - y * PixelsPerUnit)];

    [Test]
    public void NothingIsComplainedAbout() => Assert.That(run.Errors, Is.Empty);

    [Test]
    public void TheDropStartsAtTheCrestAndSpreads()
    {
        Picture first = Frame(0), last = Frame(Frames - 1);
        Assert.That(At(first, 0.01f, 0.01f), Is.EqualTo((255, 255, 255)));
        Assert.That(At(last, 0.01f, 0.01f), Is.Not.EqualTo((255, 255, 255)));
        Assert.That(At(first, 0.6f, 0.01f).R, Is.LessThan(10), "flat water is green");
        int changed = 0;
        for (float x = 0.01f; x < 0.75f; x += 0.025f)
            if (At(last, x, 0.01f) != At(first, x, 0.01f)) changed++;
        Assert.That(changed, Is.GreaterThan(8), "a ring runs outwards");
        Assert.That(At(last, 0.77f, 0.77f), Is.EqualTo((0, 255, 0)), "and has not reached the corner");
    }

    [Test]
    public void TheWaveIsSymmetric()
    {
        Picture picture = Frame(Frames - 1);
        int half = (int)(0.8f * PixelsPerUnit) - 2;
        for (int y = -half; y < half; y += 7)
            for (int x = -half; x < 0; x += 7)
            {
                var here = picture[Width / 2 + x, Height / 2 + y];
                Assert.That(Difference(here, picture[Width / 2 - 1 - x, Height / 2 + y]), Is.LessThan(4), $"left and right at {x}, {y}");
                Assert.That(Difference(here, picture[Width / 2 + x, Height / 2 - 1 - y]), Is.LessThan(4), $"above and below at {x}, {y}");
            }
    }

    [Test]
    public void ThePrefabInstanceIsPlacedTurnedAndTinted()
    {
        Picture first = Frame(0);
        Assert.That(At(first, 1.3f, 0.01f), Is.EqualTo((255, 0, 0)));
        Assert.That(At(first, 1.3f + 0.1f, 0.01f), Is.EqualTo((255, 0, 0)), "the tip points to the right");
        var (r, g, b) = At(first, 1.3f - 0.1f, 0.0f);
        Assert.That((r, g), Is.EqualTo((0, 0)), "the notch shows the background");
        Assert.That(b, Is.EqualTo(128).Within(2));
        Assert.That(At(first, 1.3f - 0.1f, 0.1f).R, Is.EqualTo(255), "the wings do not");
    }

    [Test]
    public void TheFilesAreThoseOfTheContract()
    {
        string[] rows = File.ReadAllLines(Path.Combine(folder, "timings.csv"));
        Assert.That(rows, Has.Length.EqualTo(Frames + 1));
        Assert.That(rows[0], Does.StartWith("frame,time_s,cpu_ms,gpu_ms"));
        Assert.That(rows.Skip(1).Select(r => r.Split(',')[0]), Is.EqualTo(Enumerable.Range(0, Frames).Select(i => i.ToString(CultureInfo.InvariantCulture))));
        Assert.That(rows.Skip(1).All(r => double.Parse(r.Split(',')[3], CultureInfo.InvariantCulture) > 0), Is.True, "GPU time of every frame");
        using JsonDocument summary = JsonDocument.Parse(File.ReadAllText(Path.Combine(folder, "summary.json")));
        JsonElement root = summary.RootElement;
        Assert.That(root.GetProperty("scene").GetString(), Is.EqualTo("Assets/Scenes/Ripples.unity"));
        Assert.That(root.GetProperty("frames").GetInt32(), Is.EqualTo(Frames));
        Assert.That(root.GetProperty("simulated_s").GetDouble(), Is.EqualTo((Frames - 1) / 30.0).Within(1e-4));
        Assert.That(root.GetProperty("device").GetString(), Is.Not.Empty);
        Assert.That(root.GetProperty("gpu_memory_bytes").GetInt64(), Is.GreaterThan(0));
        Assert.That(Directory.GetFiles(folder, "*.part"), Is.Empty);
    }

    [Test]
    public void AnInterruptLeavesValidFiles()
    {
        string output = Path.Combine(folder, "interrupted");
        using Process process = PlayerProcess.Start(Arguments(output, "--seconds", "3600"));
        string frame = Path.Combine(output, "frame_00003.png");
        for (int i = 0; i < 600 && !File.Exists(frame) && !process.HasExited; i++) Thread.Sleep(100);
        Assert.That(process.HasExited, Is.False, () => PlayerProcess.Finish(process).Errors);
        Assert.That(Kill(process.Id, Interrupt), Is.Zero);
        PlayerProcess ended = PlayerProcess.Finish(process, TimeSpan.FromMinutes(1));
        Assert.That(ended.ExitCode, Is.EqualTo(130), ended.Errors);
        Assert.That(ended.Output, Does.Contain("interrupted: "));
        int frames = Directory.GetFiles(output, "frame_*.png").Length;
        using JsonDocument summary = JsonDocument.Parse(File.ReadAllText(Path.Combine(output, "summary.json")));
        Assert.That(summary.RootElement.GetProperty("frames").GetInt32(), Is.EqualTo(frames).And.GreaterThan(3));
        Assert.That(File.ReadAllLines(Path.Combine(output, "timings.csv")), Has.Length.EqualTo(frames + 1));
        foreach (string file in Directory.GetFiles(output, "frame_*.png")) Assert.That(Picture.Read(file).Width, Is.EqualTo(Width));
    }

    [Test]
    public void AStaticThatShowsInTheSecondPlayIsFound()
    {
        string output = Path.Combine(folder, "twice");
        PlayerProcess twice = PlayerProcess.Run(Arguments(output, "--seconds", "0.1", "--twice", "--executeMethod", "Ripples.Afterglow.TurnOn"));
        Assert.That((twice.ExitCode, twice.Errors.TrimEnd()), Is.EqualTo((1, "sphplayer: --twice: frame 1 of the second play differs from the first's. What did the first leave in a static?")));
        Assert.That(Directory.GetFiles(output, "frame_*.png"), Has.Length.EqualTo(4), "the first play's");
    }

    [TestCase("--speed", "3", "--speed is not a flag of play")]
    [TestCase("--scene", "Assets/Scenes/Nowhere.unity", "--scene is given twice")]
    [TestCase("--seconds", "none", "--seconds must be a number of seconds")]
    [TestCase("--device", "No such card", "No Vulkan device 'No such card'. There is: ")]
    [TestCase("--executeMethod", "Ripples.Nothing.Run", "--executeMethod: no class 'Ripples.Nothing'")]
    public void WrongFlagsAreOneLineAndExitCode2(string flag, string value, string message)
    {
        PlayerProcess wrong = PlayerProcess.Run(Arguments(Path.Combine(folder, "wrong"), flag, value));
        Assert.That(wrong.ExitCode, Is.EqualTo(2));
        Assert.That(wrong.Errors.TrimEnd().Split('\n'), Has.Length.EqualTo(1));
        Assert.That(wrong.Errors, Does.StartWith("sphplayer: " + message));
    }

    [Test]
    public void AMissingSceneIsNamed()
    {
        PlayerProcess wrong = PlayerProcess.Run("play", "--project", Project, "--scene", "Assets/Nowhere.unity", "--out", Path.Combine(folder, "wrong"));
        Assert.That((wrong.ExitCode, wrong.Errors.TrimEnd()), Is.EqualTo((2, $"sphplayer: --scene: 'Assets/Nowhere.unity' is not a file of the project '{Project}'.")));
    }

    private static int Difference((int R, int G, int B) a, (int R, int G, int B) b) =>
        Math.Max(Math.Abs(a.R - b.R), Math.Max(Math.Abs(a.G - b.G), Math.Abs(a.B - b.B)));

    private const int Interrupt = 2;

    [DllImport("libc", EntryPoint = "kill")]
    private static extern int Kill(int process, int signal);
}
