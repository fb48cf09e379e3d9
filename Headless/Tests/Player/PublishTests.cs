using System.Diagnostics;
using NUnit.Framework;

namespace Headless.Tests.Player;

/// <summary>./run publish in a project of its own, with a dotnet that writes two small files at once.</summary>
public sealed class PublishTests
{
    private const string List = "sphplayer-files.txt";

    private string root = "", outside = "";

    [SetUp]
    public void MakeProject()
    {
        string folder = Directory.CreateTempSubdirectory("publish").FullName;
        root = Path.Combine(folder, "project");
        outside = Path.Combine(folder, "out side");
        Write("Headless/Publish/publish.sh", File.ReadAllText(Path.Combine(Path.GetDirectoryName(PlayerProcess.ProjectsFolder)!, "../Publish/publish.sh")));
        Write("run", "#!/bin/sh\necho \"$@\" >> \"$(dirname \"$0\")/builds\"\n");
        Write("bin/dotnet", """
            #!/bin/sh
            test -e "$(dirname "$0")/broken" && exit 1
            echo "$@" > "$(dirname "$0")/../words"
            while [ "$1" != -o ]; do shift; done
            mkdir -p "$2/lib" && echo player > "$2/sphplayer" && echo library > "$2/lib/a.dll"
            """);
        Write("Build/ScriptAssemblies/SphFluid.dll", "a");
        Write("Build/ScriptAssemblies/SphFluid.Universal.dll", "g");
        Write("Build/ScriptAssemblies/SphFluid.Thesis.dll", "e");
        Write("Build/ScriptAssemblies/SphFluid.Playback.dll", "c");
        Write("Build/ScriptAssemblies/SphFluid.PySph.dll", "d");
        Write("Build/ScriptAssemblies/SphFluid.Validation.Laboratory.dll", "f");
        Write("Build/ScriptAssemblies/SphFluid.Validation.dll", "b");
        foreach (string program in new[] { "run", "bin/dotnet" })
            File.SetUnixFileMode(Path.Combine(root, program), UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute);
    }

    [TearDown]
    public void Delete() => Directory.Delete(Path.GetDirectoryName(root)!, recursive: true);

    [Test]
    public void AFolderThatIsNotThereIsMadeAndListed()
    {
        Assert.That(Publish(outside).Code, Is.Zero);
        Assert.That(FilesIn(outside), Is.EqualTo(new[] { "ScriptAssemblies/SphFluid.Playback.dll", "ScriptAssemblies/SphFluid.PySph.dll", "ScriptAssemblies/SphFluid.Thesis.dll", "ScriptAssemblies/SphFluid.Universal.dll", "ScriptAssemblies/SphFluid.Validation.Laboratory.dll", "ScriptAssemblies/SphFluid.Validation.dll", "ScriptAssemblies/SphFluid.dll", "lib/a.dll", "sphplayer", List }));
        Assert.That(Directory.GetFileSystemEntries(Path.GetDirectoryName(outside)!), Has.Length.EqualTo(2), "nothing is left beside it");
    }

    [Test]
    public void WithoutAFolderItIsBuildPublish()
    {
        Assert.That(Publish().Code, Is.Zero);
        Assert.That(File.Exists(Path.Combine(root, "Build/publish/sphplayer")));
    }

    [Test]
    public void AnEmptyFolderIsFilled()
    {
        Directory.CreateDirectory(outside);
        Assert.That(Publish(outside).Code, Is.Zero);
        Assert.That(File.Exists(Path.Combine(outside, "sphplayer")));
    }

    [Test]
    public void WhatPublishWroteBeforeIsReplaced()
    {
        Publish(outside);
        File.AppendAllText(Path.Combine(root, "bin/dotnet"), "\necho newer > \"$2/sphplayer\"; rm \"$2/lib/a.dll\"; rmdir \"$2/lib\"\n");
        Assert.That(Publish(outside).Code, Is.Zero);
        Assert.That(FilesIn(outside), Has.No.Member("lib/a.dll"));
        Assert.That(Directory.Exists(Path.Combine(outside, "lib")), Is.False);
        Assert.That(File.ReadAllText(Path.Combine(outside, "sphplayer")), Is.EqualTo("newer\n"));
    }

    [Test]
    public void AFolderLeftByAnInterruptionIsFilled()
    {
        Publish(outside);
        File.Delete(Path.Combine(outside, "sphplayer"));
        Assert.That(Publish(outside).Code, Is.Zero);
        Assert.That(File.Exists(Path.Combine(outside, "sphplayer")));
    }

    [TestCase("holiday.jpg")]
    [TestCase("lib/mine.txt")]
    [TestCase(".hidden")]
    [TestCase("a\nb.txt")]
    public void AFileOfTheUsersStaysAndIsNamed(string file)
    {
        Publish(outside);
        AssertRefused(outside, Path.Combine(outside, file));
    }

    [Test]
    public void AFolderOfTheUsersStays()
    {
        Directory.CreateDirectory(outside);
        AssertRefused(outside, Path.Combine(outside, "thesis.docx"));
    }

    [Test]
    public void AnEmptyFolderInItStays()
    {
        Publish(outside);
        Directory.CreateDirectory(Path.Combine(outside, "drafts"));
        AssertRefused(outside);
        Assert.That(Directory.Exists(Path.Combine(outside, "drafts")));
    }

    [Test]
    public void APublishedFileThatWasChangedStays()
    {
        Publish(outside);
        File.WriteAllText(Path.Combine(outside, "lib/a.dll"), "patched");
        AssertRefused(outside);
        Assert.That(File.ReadAllText(Path.Combine(outside, "lib/a.dll")), Is.EqualTo("patched"));
    }

    [Test]
    public void AListThatPointsElsewhereIsRefused()
    {
        Directory.CreateDirectory(outside);
        File.WriteAllText(Path.Combine(outside, List), new string('0', 64) + "  ./../project/run\n");
        AssertRefused(outside);
        Assert.That(File.Exists(Path.Combine(root, "run")));
    }

    [Test]
    public void AFailedBuildChangesNothing()
    {
        Publish(outside);
        File.WriteAllText(Path.Combine(root, "bin/broken"), "");
        string[] before = FilesIn(outside);
        Assert.That(Publish(outside).Code, Is.EqualTo(1));
        Assert.That(FilesIn(outside), Is.EqualTo(before));
        Assert.That(Directory.GetFileSystemEntries(Path.GetDirectoryName(outside)!), Has.Length.EqualTo(2));
    }

    [TestCase("/")]
    [TestCase("")]
    [TestCase(".")]
    [TestCase("..")]
    [TestCase("Headless")]
    [TestCase("Packages/new")]
    [TestCase("Build")]
    [TestCase("run")]
    [TestCase("--out")]
    [TestCase("~")]
    public void PlacesThatAreNoOutputAreRefused(string target) => AssertRefused(target == "~" ? Environment.GetEnvironmentVariable("HOME")! : target);

    [TestCase("linux", "linux-x64")]
    [TestCase("windows", "win-x64")]
    public void TheSystemIsThatOfTheFlag(string system, string runtime)
    {
        Assert.That(Publish("--system", system, outside).Code, Is.Zero);
        Assert.That(File.ReadAllText(Path.Combine(root, "words")), Does.Contain($"PublishRuntime={runtime}"));
    }

    [TestCase("--system", "mac")]
    [TestCase("--measure", "")]
    [TestCase("--measure=mac", "out")]
    public void AnotherSystemIsRefusedBeforeAnythingIsBuilt(string flag, string value)
    {
        var (code, errors) = Publish(flag, value);
        Assert.That(code, Is.EqualTo(2));
        Assert.That(errors, Does.Contain("takes linux or windows"));
        Assert.That(File.Exists(Path.Combine(root, "builds")), Is.False);
    }

    [Test]
    public void TwoFoldersAreRefused()
    {
        var (code, errors) = Publish(outside, "other");
        Assert.That((code, errors), Is.EqualTo((2, "publish: one folder is expected, not 2: other is too much.\n")));
    }

    private void AssertRefused(string target, string? users = null)
    {
        if (users is not null) File.WriteAllText(users, "years of work");
        File.Delete(Path.Combine(root, "builds"));
        string[] before = FilesIn(root);
        var (code, errors) = Publish(target);
        Assert.That(code, Is.EqualTo(2), errors);
        Assert.That(errors, Does.StartWith("publish: "));
        Assert.That(FilesIn(root), Is.EqualTo(before), "refused before anything is built");
        if (users is not null) Assert.That(File.ReadAllText(users), Is.EqualTo("years of work"));
    }

    private (int Code, string Errors) Publish(params string[] words)
    {
        var info = new ProcessStartInfo("bash", [Path.Combine(root, "Headless/Publish/publish.sh"), .. words])
        {
            WorkingDirectory = root, RedirectStandardOutput = true, RedirectStandardError = true,
        };
        info.Environment["PATH"] = Path.Combine(root, "bin") + ":" + Environment.GetEnvironmentVariable("PATH");
        using Process process = Process.Start(info)!;
        Task<string> output = process.StandardOutput.ReadToEndAsync();
        string errors = process.StandardError.ReadToEnd();
        process.WaitForExit();
        return (process.ExitCode, errors);
    }

    private static string[] FilesIn(string folder) =>
        [.. Directory.GetFiles(folder, "*", SearchOption.AllDirectories).Select(f => Path.GetRelativePath(folder, f)).Order(StringComparer.Ordinal)];

    private void Write(string file, string text)
    {
        string path = Path.Combine(root, file);
        Directory.CreateDirectory(Path.GetDirectoryName(path)!);
        File.WriteAllText(path, text);
    }
}
