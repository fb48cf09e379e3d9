using System.Diagnostics;
using Headless.Help;
using Headless.Tests.Fuzz;
using NUnit.Framework;

namespace Headless.Tests.Help;

/// <summary>./run --help: made from the flags that the parsers read, committed, and what the shell refuses by them.</summary>
public sealed class HelpTests
{
    private static string Program => Path.Combine(AppContext.BaseDirectory, "sphplayer");

    private static IEnumerable<Verb> All() => Verbs.All;

    private static IEnumerable<TestCaseData> Examples() =>
        from verb in Verbs.All
        from example in verb.Examples
        select new TestCaseData(verb, example.Words).SetName($"TheExampleHasFlagsThatThereAre(./run {verb.Name} {example.Words})");

    [Test]
    public void TheCommittedTextsAreThoseOfTheTables() =>
        Assert.That(HelpFiles.Stale(FuzzProject.Repository), Is.Empty, "./run help --update writes them anew");

    [Test]
    public void AStaleAMissingAndASuperfluousTextAreFound()
    {
        DirectoryInfo project = Directory.CreateTempSubdirectory("help-");
        try
        {
            HelpFiles.Write(project.FullName);
            string folder = Path.Combine(project.FullName, HelpFiles.Folder);
            Assert.That(HelpFiles.Stale(project.FullName), Is.Empty);
            File.AppendAllText(Path.Combine(folder, "play.txt"), "more\n");
            File.Delete(Path.Combine(folder, "leaks.txt"));
            File.WriteAllText(Path.Combine(folder, "old.txt"), "");
            Assert.That(HelpFiles.Stale(project.FullName), Is.EqualTo(new[] { "leaks.txt", "old.txt", "play.txt" }));
        }
        finally
        {
            project.Delete(recursive: true);
        }
    }

    [TestCaseSource(nameof(All))]
    public void AVerbHasItsFlagsOnceAndInLinesOfAHundredLetters(object verb)
    {
        var v = (Verb)verb;
        string[] lines = HelpText.Of(v).Split('\n');
        Assert.That(lines.Select(l => l.Length).Max(), Is.LessThanOrEqualTo(100));
        foreach (Flag flag in v.Flags) Assert.That(lines.Count(l => l.StartsWith($"  {flag.Name} ", StringComparison.Ordinal)), Is.InRange(1, 2), flag.Name);
        Assert.That(v.Flags.Select(f => f.Name), Is.Unique);
        foreach (Flag flag in v.Flags) Assert.That(flag.Text, Is.Not.Empty.And.Not.EndWith("."), flag.Name);
    }

    [TestCaseSource(nameof(Examples))]
    public void AnExampleIsPossible(object verb, string words)
    {
        string[] known = [.. ((Verb)verb).AllFlags.Select(f => f.Name)];
        foreach (string word in words.Split(' ').Where(w => w.StartsWith("--", StringComparison.Ordinal))) Assert.That(known, Does.Contain(word));
        foreach (string word in words.Split(' ').Where(w => w.EndsWith(".unity", StringComparison.Ordinal)))
            Assert.That(File.Exists(Path.Combine(FuzzProject.Repository, word)), Is.True, word);
    }

    [TestCase("play: --sped is not a flag; did you mean --seed? ./run play --help tells what it takes.", "--sped", "3")]
    [TestCase("play: --szie is not a flag; did you mean --size? ./run play --help tells what it takes.", "play", "--szie=1x1")]
    [TestCase("leaks: --scen is not a flag; did you mean --scene? ./run leaks --help tells what it takes.", "leaks", "--scen", "cup")]
    [TestCase("devices: --all is not a flag. ./run devices --help tells what it takes.", "devices", "--all")]
    [TestCase("run: 'paly' is not a verb; did you mean play? ./run --help lists them.", "paly", "--seconds", "1")]
    [TestCase("run: 'x' is not a verb. ./run --help lists them.", "help", "x")]
    [TestCase("build: 'foo' is not a solution. Headless.slnx is all, Play.slnx the part that plays and measures.", "build", "foo")]
    [TestCase("build: 'play.slnx' is not a solution; did you mean Play.slnx? Headless.slnx is all, Play.slnx the part that plays and measures.", "build", "play.slnx")]
    [TestCase("play: 'Fountain' and --scene name two scenes; give one.", "play", "Fountain", "--seconds", "1", "--scene", "DamBreak")]
    [TestCase("list: 'scenes' is not understood; it takes no words.", "list", "scenes")]
    [TestCase("play: 'fountan' is neither a .unity file nor a sample; did you mean fountain? The samples are DamBreak Fountain.", "play", "fountan")]
    [TestCase("play: 'fountan' is neither a .unity file nor a sample; did you mean fountain? The samples are DamBreak Fountain.", "--scene", "fountan")]
    [TestCase("export: 'x' is neither a .unity file nor a sample. The samples are DamBreak Fountain.", "export", "--scene=x")]
    [Platform(Exclude = "Win")]
    public void TheShellRefusesInOneLineBeforeAnythingIsBuilt(string message, params string[] words)
    {
        (int code, string output, string errors) = Shell(words);
        Assert.That((code, output, errors), Is.EqualTo((2, "", message + "\n")));
    }

    [Test]
    [Platform(Exclude = "Win")]
    public void NoQuestionIsAskedWithoutAPlayer() =>
        Assert.That(Shell(["paly"], built: false).Errors, Is.EqualTo("run: 'paly' is not a verb. ./run --help lists them.\n"));

    [TestCase("run.txt", "--help")]
    [TestCase("run.txt", "help")]
    [TestCase("play.txt", "play", "--seconds", "3", "-h")]
    [TestCase("mutate.txt", "mutate", "--help")]
    [TestCase("surfaces.txt", "help", "surfaces")]
    [Platform(Exclude = "Win")]
    public void TheShellShowsAText(string file, params string[] words)
    {
        (int code, string output, string errors) = Shell(words);
        Assert.That((code, errors), Is.EqualTo((0, "")));
        Assert.That(output, Is.EqualTo(File.ReadAllText(Path.Combine(FuzzProject.Repository, HelpFiles.Folder, file))));
    }

    [TestCase("-n 40", "devices: this shell allows 40 open files, and the player needs 256: ulimit -n 256, or unlimited.")]
    [TestCase("-v 3000000", "devices: this shell allows 3000000 KB of memory addresses, and the player needs 8388608: ulimit -v 8388608, or unlimited.")]
    [TestCase("-f 2000", "devices: this shell allows 2000 KB a file, and the player needs 4194304: ulimit -f 4194304, or unlimited.")]
    [Platform(Exclude = "Win")]
    public void ALimitThatThePlayerCannotWorkWithinIsALine(string limit, string message) =>
        Assert.That(Shell(["devices"], $"ulimit {limit} && bash \"$0\" \"$@\""), Is.EqualTo((2, "", message + "\n")));

    [Test]
    [Platform(Exclude = "Win")]
    public void AClosedOutputIsALineAndNoneOfTheProgramsGetsItsNumber()
    {
        (int code, string _, string errors) = Shell(["--version"], "bash \"$0\" \"$@\" >&- <&-");
        Assert.That((code, errors), Is.EqualTo((0, "run: standard output is closed: only messages are shown.\n")));
    }

    [Test]
    [Platform(Exclude = "Win")]
    public void TheVersionIsThatOfThePackage() => Assert.That(Shell(["--version"]), Is.EqualTo((0, "SPH Fluid 1.2.3-test\n", "")));

    [TestCase("setup run", "build", "Play.slnx")]
    [TestCase("setup test", "build")]
    [TestCase("setup test", "build", "Headless.slnx")]
    [Platform(Exclude = "Win")]
    public void ABuildInstallsWhatItNeeds(string asked, params string[] words) => Assert.That(Shell(words).Output, Does.StartWith(asked + "\n"));

    [TestCase("fountain")]
    [TestCase("FOUNTAIN")]
    [TestCase("Packages/com.sphfluid/Samples~/Fountain/Fountain.unity")]
    [Platform(Exclude = "Win")]
    public void ASampleIsASceneByItsName(string name)
    {
        foreach (string[] words in new string[][] { ["--scene", name, "--seconds", "1"], ["play", name, "--seconds", "1"] })
        {
            (int code, string output, string errors) = Shell(words);
            Assert.That(code, Is.Zero, errors);
            Assert.That(output, Does.Match(@"played .*--scene \S*Packages/com\.sphfluid/Samples~/Fountain/Fountain\.unity --seconds 1 --out \S*Build/play --\s"));
        }
    }

    [Test]
    [Platform(Exclude = "Win")]
    public void ScenesLiquidsAndMethodsAreListed()
    {
        (int code, string output, string errors) = Shell(["list"]);
        Assert.That((code, errors), Is.EqualTo((0, "")));
        Assert.That(output, Does.Match(@"(?m)^  DamBreak +A dam breaks\.$").And.Match(@"(?m)^  Fountain +A \""nozzle\""\.$"));
        Assert.That(output, Does.Contain("  sea-water\n").And.EndWith("  thesis-printed\n  thesis\n  robust\n  standard\n  automatic\n"));
    }

    /// <summary>
    /// run and the texts, in a folder of their own with two samples, a set-up that says what it is asked for, the player, and in place of .NET what
    /// "builds" one that says what it is to play.
    /// </summary>
    private static (int Code, string Output, string Errors) Shell(string[] words, string script = "bash \"$0\" \"$@\"", bool built = true)
    {
        DirectoryInfo folder = Directory.CreateTempSubdirectory("run-");
        try
        {
            Directory.CreateDirectory(Path.Combine(folder.FullName, HelpFiles.Folder));
            string run = Path.Combine(folder.FullName, "run");
            File.Copy(Path.Combine(FuzzProject.Repository, "run"), run);
            foreach (string text in Directory.EnumerateFiles(Path.Combine(FuzzProject.Repository, HelpFiles.Folder)))
                File.Copy(text, Path.Combine(folder.FullName, HelpFiles.Folder, Path.GetFileName(text)));
            foreach (string sample in new[] { "Fountain", "DamBreak" }) Add(folder, $"Packages/com.sphfluid/Samples~/{sample}/{sample}.unity", "");
            Add(folder, "Packages/com.sphfluid/package.json", """
                {
                  "name": "com.sphfluid",
                  "version": "1.2.3-test",
                  "samples": [
                    {
                      "description": "A dam breaks.",
                      "path": "Samples~/DamBreak"
                    },
                    {
                      "description": "A \"nozzle\".",
                      "path": "Samples~/Fountain"
                    }
                  ]
                }

                """);
            Add(folder, "setup.sh", "#!/bin/sh\necho \"setup $1\"\nmkdir -p \"$(dirname \"$0\")/Build\"\n");
            if (built) Add(folder, "Build/dotnet/bin/Headless.Player/release/sphplayer", $"#!/bin/sh\nexec '{Program}' \"$@\"\n");
            Add(folder, "programs/dotnet", """
                #!/bin/sh
                build=$(dirname "$0")/../Build
                mkdir -p "$build/dotnet/bin/Headless.Player/release" "$build/dotnet/bin/SphFluid/release"
                printf '#!/bin/sh\necho "played $*"\n' > "$build/dotnet/bin/Headless.Player/release/sphplayer"
                chmod +x "$build/dotnet/bin/Headless.Player/release/sphplayer"

                """);
            var start = new ProcessStartInfo("bash", ["-c", script, run, .. words]) { RedirectStandardOutput = true, RedirectStandardError = true };
            start.Environment["PATH"] = $"{Path.Combine(folder.FullName, "programs")}:{start.Environment["PATH"]}";
            using Process process = Process.Start(start)!;
            Task<string> errors = process.StandardError.ReadToEndAsync();
            string output = process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            return (process.ExitCode, output, errors.Result);
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }

    private static void Add(DirectoryInfo folder, string name, string text)
    {
        string file = Path.Combine(folder.FullName, name);
        Directory.CreateDirectory(Path.GetDirectoryName(file)!);
        File.WriteAllText(file, text.ReplaceLineEndings("\n"));
        if (!OperatingSystem.IsWindows()) File.SetUnixFileMode(file, (UnixFileMode)0b111_101_101);
    }
}
