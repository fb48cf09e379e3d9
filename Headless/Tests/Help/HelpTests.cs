using System.Diagnostics;
using Headless.Help;
using Headless.Tests.Fuzz;
using NUnit.Framework;

namespace Headless.Tests.Help;

/// <summary>./run --help: made from the flags that the parsers read, committed, and what the shell refuses by them.</summary>
public sealed class HelpTests
{
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

    [TestCase("play: --sped is not a flag. Did you mean --seed? ./run play --help tells what it takes.", "--sped", "3")]
    [TestCase("play: --szie is not a flag. Did you mean --size? ./run play --help tells what it takes.", "play", "--szie=1x1")]
    [TestCase("leaks: --scen is not a flag. Did you mean --scene? ./run leaks --help tells what it takes.", "leaks", "--scen", "cup")]
    [TestCase("devices: --all is not a flag. ./run devices --help tells what it takes.", "devices", "--all")]
    [TestCase("run: 'paly' is not a verb. Did you mean play? ./run --help lists them.", "paly", "--seconds", "1")]
    [TestCase("run: 'x' is not a verb. ./run --help lists them.", "help", "x")]
    [Platform(Exclude = "Win")]
    public void TheShellRefusesInOneLineBeforeAnythingIsBuilt(string message, params string[] words)
    {
        (int code, string output, string errors) = Shell(words);
        Assert.That((code, output, errors), Is.EqualTo((2, "", message + "\n")));
    }

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

    /// <summary>run and the texts alone, in a folder without anything else: nothing can be built there.</summary>
    private static (int Code, string Output, string Errors) Shell(string[] words)
    {
        DirectoryInfo folder = Directory.CreateTempSubdirectory("run-");
        try
        {
            Directory.CreateDirectory(Path.Combine(folder.FullName, HelpFiles.Folder));
            string run = Path.Combine(folder.FullName, "run");
            File.Copy(Path.Combine(FuzzProject.Repository, "run"), run);
            foreach (string text in Directory.EnumerateFiles(Path.Combine(FuzzProject.Repository, HelpFiles.Folder)))
                File.Copy(text, Path.Combine(folder.FullName, HelpFiles.Folder, Path.GetFileName(text)));
            using Process process = Process.Start(new ProcessStartInfo("bash", [run, .. words]) { RedirectStandardOutput = true, RedirectStandardError = true })!;
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
}
