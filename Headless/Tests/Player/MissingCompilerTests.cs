using System.Diagnostics;
using NUnit.Framework;

namespace Headless.Tests.Player;

/// <summary>A player on a machine that has neither the compiled shaders nor a compiler.</summary>
[Category("Gpu")]
public sealed class MissingCompilerTests
{
    [Test]
    public void OneLineNamesTheShaderAndTheCure()
    {
        string folder = Directory.CreateTempSubdirectory("missing-").FullName;
        try
        {
            var start = new ProcessStartInfo(Environment.ProcessPath!,
            [
                Path.Combine(AppContext.BaseDirectory, "sphplayer.dll"), "play", "--project", Path.Combine(PlayerProcess.ProjectsFolder, "Ripples"),
                "--assemblies", PlayerProcess.AssembliesOf("Ripples"), "--scene", "Assets/Scenes/Ripples.unity", "--size", "64x64", "--out", Path.Combine(folder, "out"),
            ])
            { RedirectStandardOutput = true, RedirectStandardError = true };
            start.Environment["PATH"] = folder;
            start.Environment["XDG_CACHE_HOME"] = folder;
            PlayerProcess run = PlayerProcess.Finish(Process.Start(start)!);

            Assert.That(run.ExitCode, Is.EqualTo(1), run.Output);
            Assert.That(run.Errors.Split('\n', StringSplitOptions.RemoveEmptyEntries), Has.Length.EqualTo(1), run.Errors);
            Assert.That(run.Errors, Does.Contain("Waves.compute").And.Contain("glslang-tools"));
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }
}
