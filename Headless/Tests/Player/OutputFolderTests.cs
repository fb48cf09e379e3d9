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
        OutputFolder first = OutputFolder.Open(folder, 3, film: true);
        foreach (string name in new[] { "frame_00000.png", "frame_00001.png", "film.mp4", "summary.json", "film.mp4.part" }) Add(name);
        first.Close(2, film: true);
        string[] users = [Add("holiday.mp4"), Add("picture.png"), Add("frame_extra.png"), Add("frame_00077.png"), Add("notes.txt")];
        OutputFolder.Open(folder, 3, film: true);
        Assert.That(Directory.GetFiles(folder).Order(), Is.EqualTo(users.Append(Path.Combine(folder, OutputFolder.ListName)).Order()));
    }

    [TestCase("film.mp4")]
    [TestCase("frame_00002.png")]
    [TestCase("summary.json")]
    [TestCase("timings.csv")]
    public void AFileOfTheUsersWithANameThatIsNeededIsLeftAndNamed(string name)
    {
        string file = Add(name);
        Assert.That(() => OutputFolder.Open(folder, 3, film: true), Throws.TypeOf<UsageException>().With.Message.Contains($"holds {name}, which the player did not write"));
        Assert.That(File.ReadAllText(file), Is.EqualTo("mine"));
    }

    [Test]
    public void WithoutPicturesFilmsOfTheUsersAreInNobodysWay()
    {
        string film = Add("film.mp4"), frame = Add("frame_00000.png");
        OutputFolder.Open(folder, 0, film: false);
        Assert.That(File.Exists(film) && File.Exists(frame), Is.True);
    }

    [Test]
    public void AListThatNamesOtherFilesIsNotObeyed()
    {
        string precious = Add("thesis.tex");
        Add(OutputFolder.ListName, "thesis.tex\n../thesis.tex\n/etc/hostname\n");
        OutputFolder.Open(folder, 3, film: true);
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
        OutputFolder.Open(folder, 3, film: true);
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
