using System.Diagnostics;
using Headless.Tests.Fuzz;
using NUnit.Framework;

namespace Headless.Tests.Structure;

/// <summary>setup.sh with programs of ours in the place of the system's.</summary>
[Platform(Exclude = "Win")]
public sealed class SetupScriptTests
{
    private string folder = "";

    [SetUp]
    public void SetUp()
    {
        folder = Directory.CreateTempSubdirectory("setup-").FullName;
        File.Copy(Path.Combine(FuzzProject.Repository, "setup.sh"), Path.Combine(folder, "setup.sh"));
        Directory.CreateDirectory(Path.Combine(folder, "programs"));
        Program("dotnet", "echo '10.0.100 [/usr/share/dotnet/sdk]'");
        Program("dpkg-query", "exit 1");
        Program("sudo", "exec \"$@\"");
        // Only the first of many seconds is waited for.
        Program("sleep", "echo \"sleep $1\" >> ../log");
        foreach (string name in new[] { "glslangValidator", "gnuplot", "ffmpeg" }) Program(name, "exit 0");
    }

    [TearDown]
    public void TearDown() => Directory.Delete(folder, recursive: true);

    [Test]
    public void AnotherAptIsWaitedForAndNothingForTestsIsInstalled()
    {
        Program("apt-get", """
            echo "apt-get $*" >> ../log
            [ "$(grep -c ' update' ../log)" -gt 2 ] || { echo 'E: Could not get lock /var/lib/apt/lists/lock. It is held by process 1 (apt-get)'; exit 100; }
            """);
        (int code, string errors) = Run();
        Assert.That(code, Is.Zero, errors);
        Assert.That(errors, Is.EqualTo("setup: installing libvulkan1 mesa-vulkan-drivers\nsetup: waiting for another apt\n"));
        string[] log = File.ReadAllLines(Path.Combine(folder, "log"));
        Assert.That(log.Count(l => l.StartsWith("sleep", StringComparison.Ordinal)), Is.EqualTo(2));
        Assert.That(log[^1], Does.Match("DPkg::Lock::Timeout=[0-9]+ install -y --no-install-recommends libvulkan1 mesa-vulkan-drivers$"));
    }

    [Test]
    public void WhatAptSaysOfAFailureIsShown()
    {
        Program("apt-get", "echo 'E: Unable to locate package'; exit 100");
        (int code, string errors) = Run();
        Assert.That(code, Is.EqualTo(1));
        Assert.That(errors, Does.Contain("\nE: Unable to locate package\nsetup: the packages could not be installed (all of it: "));
    }

    [Test]
    public void ACacheUnderItsOldNameIsTakenAlong()
    {
        string old = Path.Combine(folder, "cache", "sphfluid"), now = Path.Combine(folder, "cache", Path.GetFileName(Headless.Files.UserCache.Folder));
        Directory.CreateDirectory(old);
        File.WriteAllText(Path.Combine(old, "kept"), "");
        Run();
        Assert.That(Path.Combine(now, "kept"), Does.Exist);
        Assert.That(old, Does.Not.Exist);
    }

    private (int Code, string Errors) Run()
    {
        var start = new ProcessStartInfo("bash", ["setup.sh"]) { WorkingDirectory = folder, RedirectStandardOutput = true, RedirectStandardError = true };
        start.Environment["PATH"] = $"{Path.Combine(folder, "programs")}:{start.Environment["PATH"]}";
        start.Environment["XDG_CACHE_HOME"] = Path.Combine(folder, "cache");
        using Process process = Process.Start(start)!;
        Task<string> errors = process.StandardError.ReadToEndAsync();
        process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        return (process.ExitCode, errors.Result);
    }

    private void Program(string name, string script)
    {
        string file = Path.Combine(folder, "programs", name);
        File.WriteAllText(file, $"#!/bin/sh\ncd \"$(dirname \"$0\")\"\n{script}\n".ReplaceLineEndings("\n"));
        File.SetUnixFileMode(file, (UnixFileMode)0b111_101_101);
    }
}
