using Headless.Player;
using Headless.Player.Output;
using NUnit.Framework;

namespace Headless.Tests.Player;

public sealed class OutputFolderTests
{
    private string folder = "";

    [SetUp]
    public void SetUp() => folder = Directory.CreateTempSubdirectory("player-folder-").FullName;

    [TearDown]
    public void TearDown() => Directory.Delete(folder, recursive: true);

    private string Add(string name, string text = "mine")
    {
        string file = Path.Combine(folder, name);
        File.WriteAllText(file, text);
        return file;
    }

    [Test]
    public void WhatAnEarlierRunWroteIsRemovedAndNothingElse()
    {
        using (OutputFolder first = OutputFolder.Open(folder, 3, film: true))
        {
            first.Begin();
            foreach (string name in new[] { "frame_00000.png", "frame_00001.png", "film.mp4", "summary.json", "film.mp4.part" }) Add(name);
            first.Close(2, film: true);
        }
        string[] users = [Add("holiday.mp4"), Add("picture.png"), Add("frame_extra.png"), Add("frame_00077.png"), Add("notes.txt")];
        string[] before = Directory.GetFiles(folder);
        OutputFolder.Open(folder, 3, film: true).Dispose();
        Assert.That(Directory.GetFiles(folder), Is.EquivalentTo(before), "nothing goes before there is something to write");
        using (OutputFolder second = OutputFolder.Open(folder, 3, film: true)) second.Begin();
        Assert.That(Directory.GetFiles(folder), Is.EquivalentTo(users.Append(Path.Combine(folder, OutputFolder.ListName))));
    }

    [TestCase("notes.txt")]
    [TestCase(".hidden")]
    [TestCase("sub/notes.txt")]
    [TestCase("film.mp4")]
    public void AFolderThatThePlayerDidNotMakeIsRefusedAndStaysAsItIs(string name)
    {
        string file = Path.Combine(folder, name);
        Directory.CreateDirectory(Path.GetDirectoryName(file)!);
        File.WriteAllText(file, "mine");
        string[] before = Directory.GetFileSystemEntries(folder, "*", SearchOption.AllDirectories);
        Assert.That(() => OutputFolder.Open(folder, 0, film: false), Throws.TypeOf<UsageException>().With.Message.Contains($"is not empty, and the player did not make it. Name a new folder, such as '{folder}{Path.DirectorySeparatorChar}play'"));
        Assert.That(Directory.GetFileSystemEntries(folder, "*", SearchOption.AllDirectories), Is.EquivalentTo(before));
    }

    [Test]
    public void AFolderInUseIsRefusedUntilItIsGivenUp()
    {
        string path = Path.Combine(folder, "new");
        using (OutputFolder first = OutputFolder.Open(path, 3, film: true))
        {
            // Also before the first has written a list.
            Assert.That(() => OutputFolder.Open(path, 3, film: true), Throws.TypeOf<UsageException>().With.Message.Contains("another run writes to"));
            first.Begin();
            Assert.That(() => OutputFolder.Open(path, 3, film: true), Throws.TypeOf<UsageException>().With.Message.Contains("another run writes to"));
        }
        OutputFolder.Open(path, 3, film: true).Dispose();
        Assert.That(Directory.GetFiles(path).Select(Path.GetFileName), Is.EqualTo(new[] { OutputFolder.ListName }));
    }

    [Test]
    public void AFolderThatWasMadeForNothingGoes()
    {
        OutputFolder.Open(Path.Combine(folder, "new", "below"), 3, film: true).Dispose();
        Assert.That(Directory.GetFileSystemEntries(folder), Is.Empty);
    }

    [TestCase("film.mp4")]
    [TestCase("frame_00002.png")]
    [TestCase("summary.json")]
    [TestCase("timings.csv")]
    public void AFileOfTheUsersWithANameThatIsNeededIsLeftAndNamed(string name)
    {
        string file = Add(name);
        Add(OutputFolder.ListName, "");
        Assert.That(() => OutputFolder.Open(folder, 3, film: true), Throws.TypeOf<UsageException>().With.Message.Contains($"holds {name}, which the player did not write"));
        Assert.That(File.ReadAllText(file), Is.EqualTo("mine"));
    }

    [Test]
    public void WithoutPicturesFilmsOfTheUsersAreInNobodysWay()
    {
        string film = Add("film.mp4"), frame = Add("frame_00000.png");
        Add(OutputFolder.ListName, "");
        using (OutputFolder figures = OutputFolder.Open(folder, 0, film: false)) figures.Begin();
        Assert.That(File.Exists(film) && File.Exists(frame), Is.True);
    }

    [Test]
    public void AListThatNamesOtherFilesIsNotObeyed()
    {
        string precious = Add("thesis.tex");
        Add(OutputFolder.ListName, "thesis.tex\n../thesis.tex\n/etc/hostname\n");
        using (OutputFolder obeying = OutputFolder.Open(folder, 3, film: true)) obeying.Begin();
        Assert.That(File.Exists(precious), Is.True);
    }

    [Test]
    public void AFolderOfAVersionWithoutAListIsKnownByItsSummary()
    {
        Add("summary.json", "{ \"frames\": 2, \"wall_s\": 1, \"gpu_memory_bytes\": 5 }");
        Add("frame_00001.png");
        Add("film.mp4");
        string later = Add("frame_00002.png");
        Assert.That(() => OutputFolder.Open(folder, 3, film: true), Throws.TypeOf<UsageException>().With.Message.Contains("frame_00002.png"));
        File.Delete(later);
        using (OutputFolder now = OutputFolder.Open(folder, 3, film: true)) now.Begin();
        Assert.That(Directory.GetFiles(folder).Select(Path.GetFileName), Is.EqualTo(new[] { OutputFolder.ListName }));
    }

    [Test]
    public void AFileInPlaceOfTheFolderIsNamed() =>
        Assert.That(() => OutputFolder.Open(Add("file"), 3, film: true), Throws.TypeOf<UsageException>().With.Message.Contains("is a file; name a folder"));

    [Test]
    public void AFolderWithAPercentSignGetsItsFilm()
    {
        string odd = Path.Combine(folder, "a %d");
        Directory.CreateDirectory(odd);
        using var film = new Film(odd, 30);
        using (var writer = new FrameWriter(odd, film))
        {
            for (int i = 0; i < 3; i++) writer.Add(i, 5, 3, new byte[5 * 3 * 4]);
            writer.Finish();
        }
        string? problem = film.Finish();
        if (problem?.Contains("not installed") == true) Assert.Ignore(problem);
        Assert.That(problem, Is.Null);
        Assert.That(new FileInfo(Path.Combine(odd, Film.FileName)).Length, Is.GreaterThan(100));
        Assert.That(Directory.GetFiles(odd, "*.part"), Is.Empty);
    }
}
