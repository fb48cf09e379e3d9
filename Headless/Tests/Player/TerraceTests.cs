using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.Player;

/// <summary>Plays a project of someone else's that draws with a render pipeline of its own: one sun, one shadow map.</summary>
[Category("Gpu")]
public sealed class TerraceTests
{
    private const int Width = 256, Height = 192;
    private static readonly Vector3 viewer = new(0f, 2f, -8f);
    private string folder = "";
    private PlayerProcess run = null!;
    private Picture picture = null!;

    [OneTimeSetUp]
    public void Play()
    {
        folder = Directory.CreateTempSubdirectory("terrace-").FullName;
        run = PlayerProcess.Run(
            "play", "--project", Path.Combine(PlayerProcess.ProjectsFolder, "Terrace"), "--assemblies", PlayerProcess.AssembliesOf("Terrace"),
            "--scene", "Assets/Scenes/Terrace.unity", "--size", $"{Width}x{Height}", "--fps", "30", "--seconds", "0.04", "--out", folder);
        if (run.ExitCode != 0) Assert.Fail(run.Output + run.Errors);
        picture = Picture.Read(Path.Combine(folder, "frame_00001.png"));
    }

    [OneTimeTearDown]
    public void Clean() => Directory.Delete(folder, recursive: true);

    /// <summary>The camera looks along z with 60 degrees from bottom to top.</summary>
    private (int R, int G, int B) At(float x, float y, float z)
    {
        Vector3 to = new Vector3(x, y, z) - viewer;
        float perUnit = Height * 0.5f / (to.z * Mathf.Tan(30f * Mathf.Deg2Rad));
        return picture[(int)((Width * 0.5f) + (to.x * perUnit)), (int)((Height * 0.5f) - (to.y * perUnit))];
    }

    [Test]
    public void NothingIsComplainedAbout() => Assert.That(run.Errors, Is.Empty);

    [Test]
    public void TheGroundIsLitAndTheBlockShadesIt()
    {
        Assert.That(At(3f, 0f, 0f), Is.EqualTo((0, 255, 0)));
        Assert.That(At(-3f, 0f, 0f), Is.EqualTo((0, 255, 0)));

        // The sun falls to +x at 45 degrees: the block from x = -1.5 at y = 1 to x = -0.5 at y = 2 shades x = -0.5 to 1.5.
        Assert.That(At(0.5f, 0f, 0f), Is.EqualTo((0, 137, 0)), "a quarter of the light");
        Assert.That(At(-0.3f, 0f, 0f), Is.EqualTo((0, 137, 0)));
        Assert.That(At(1.8f, 0f, 0f), Is.EqualTo((0, 255, 0)));
        Assert.That(At(0.5f, 0f, 1f), Is.EqualTo((0, 255, 0)));
        (int r, int g, int b) = At(-1f, 1.5f, -0.5f);
        Assert.That((r, b), Is.EqualTo((g, g)), "the block itself is white");
    }

    [Test]
    public void TheSkyIsBehindAllAndThePaneIsBlendedOverIt()
    {
        Assert.That(At(-3f, 4f, 0f), Is.EqualTo((0, 0, 255)));
        (int r, int g, int b) = At(2f, 3.5f, 0f);
        Assert.That(g, Is.Zero);
        Assert.That(new[] { r, b }, Is.All.EqualTo(188).Within(1), "half red, half sky, in linear light");
    }
}
