using NUnit.Framework;

namespace Headless.Tests.Player;

/// <summary>What the package's shaders read of the Universal Render Pipeline is there when they read it.</summary>
[Category("Gpu")]
public sealed class UnsetPropertiesTests
{
    // The pipeline leaves these where no camera has an additional light; shaders loop over none.
    private const string WithoutLamps = "_AdditionalLights";

    // The package's own, of the branch that the Built-in pipeline takes.
    private const string Own = "_Fluid";

    private string folder = "";

    [SetUp]
    public void Make() => folder = Directory.CreateTempSubdirectory("unset-").FullName;

    [TearDown]
    public void Clean() => Directory.Delete(folder, recursive: true);

    [Test]
    public void EveryGlobalThatThePackageReadsIsSet()
    {
        string root = Conformance.ReleaseBuildTests.FindUp("Headless/Play.slnx");
        PlayerProcess run = PlayerProcess.Run(
            "play", "--project", root, "--assemblies", Path.Combine(root, "Build/ScriptAssemblies"), "--pipeline", "universal", "--unset",
            "--scene", "Packages/com.sphfluid/Samples~/DamBreak/DamBreak.unity", "--size", "96x54", "--fps", "30", "--seconds", "0.04", "--out", folder);
        Assert.That(run.ExitCode, Is.Zero, run.Output + run.Errors);
        string[] unset = [.. run.Output.Split('\n').Where(l => l.StartsWith("unset: ", StringComparison.Ordinal))];
        Assert.That(unset, Is.Not.Empty, "what the other pipeline's branch reads");
        Assert.That(unset.Where(l => !l.Contains(": " + Own) && !l.Contains(": " + WithoutLamps)), Is.Empty);
    }
}
