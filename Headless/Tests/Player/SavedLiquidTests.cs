using Headless.Tests.Fuzz;
using NUnit.Framework;

namespace Headless.Tests.Player;

/// <summary>A liquid that one process saves goes on in another as it does in the first.</summary>
[Category("Gpu")]
public sealed class SavedLiquidTests
{
    private const string Folder = "SPHFLUID_SAVE_FOLDER", Frames = "SPHFLUID_SAVE_FRAMES";

    [Test]
    public void GoesOnInAnotherProcessToTheBit()
    {
        string folder = Directory.CreateTempSubdirectory("saved-").FullName;
        Environment.SetEnvironmentVariable(Folder, folder);
        Environment.SetEnvironmentVariable(Frames, "10");
        try
        {
            Play();
            Assert.That(Path.Combine(folder, "hashes.txt"), Does.Exist);
            Play();
        }
        finally
        {
            Environment.SetEnvironmentVariable(Folder, null);
            Environment.SetEnvironmentVariable(Frames, null);
            Directory.Delete(folder, recursive: true);
        }
    }

    private static void Play()
    {
        string root = FuzzProject.Repository;
        PlayerProcess ended = PlayerProcess.Run("test", "--project", root, "--assemblies", Path.Combine(root, "Build/ScriptAssemblies"), "--mode", "play",
            "--filter", "SphFluid.Tests.SavingTests.InAnotherProcess");
        Assert.That(ended.ExitCode, Is.Zero, ended.Output + ended.Errors);
        Assert.That(ended.Output, Does.Contain("1 passed, 0 failed, 0 skipped"));
    }
}
