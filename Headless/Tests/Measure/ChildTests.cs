using System.Diagnostics;
using Headless.Measure.Children;
using NUnit.Framework;

namespace Headless.Tests.Measure;

/// <summary>Child processes that go wrong on purpose.</summary>
public sealed class ChildTests
{
    private static readonly TimeSpan soon = TimeSpan.FromSeconds(2), late = TimeSpan.FromMinutes(2);

    private string folder = "";

    private string LogFile => Path.Combine(folder, "part.log");

    [SetUp]
    public void MakeFolder() => folder = Directory.CreateTempSubdirectory("measure").FullName;

    [TearDown]
    public void Delete() => Directory.Delete(folder, recursive: true);

    [Test]
    public void OneThatHangsIsEnded() => Assert.That(Run("hang", soon).Ending, Is.EqualTo(ChildEnding.Stopped));

    [Test]
    public void OneThatDoesNotListenIsKilled() => Assert.That(Run("deaf", soon).Ending, Is.EqualTo(ChildEnding.Stopped));

    [Test]
    public void OneThatCrashesIsNamed() => Assert.That(Run("crash", late).Ending, Is.EqualTo(ChildEnding.Crashed));

    [Test]
    public void OneWithoutMemoryIsNamedWithItsLastLines()
    {
        ChildResult result = Run("memory", late);

        Assert.That(result.Ending, Is.EqualTo(ChildEnding.OutOfMemory));
        Assert.That(result.Tail, Has.Some.Contains("memory is full"));
        Assert.That(File.ReadAllText(LogFile), Does.Contain("memory is full"));
    }

    [Test]
    public void AProgramThatIsNotThereHasFailed()
    {
        using var log = new ChildLog(LogFile);
        Assert.That(Child.Run(new ProcessStartInfo(Path.Combine(folder, "nothing")), late, log, default).Ending, Is.EqualTo(ChildEnding.Failed));
    }

    [Test]
    public void AnInterruptionEndsItBeforeItsLimit()
    {
        using var log = new ChildLog(LogFile);
        Assert.That(Child.Run(Fault("hang"), late, log, new CancellationToken(true)).Ending, Is.EqualTo(ChildEnding.Stopped));
    }

    [TestCase(0, "all is well", ChildEnding.Done)]
    [TestCase(0, "out of memory in a test that expects it", ChildEnding.Done)]
    [TestCase(1, "a wrong flag", ChildEnding.Failed)]
    [TestCase(130, "interrupted", ChildEnding.Failed)]
    [TestCase(1, "vkAllocateMemory: the device's memory is full", ChildEnding.OutOfMemory)]
    [TestCase(137, "frame 3", ChildEnding.OutOfMemory)]
    [TestCase(134, "Out of memory.", ChildEnding.OutOfMemory)]
    [TestCase(139, "frame 3", ChildEnding.Crashed)]
    [TestCase(unchecked((int)0xC0000005), "frame 3", ChildEnding.Crashed)]
    public void ExitCodeAndLastLinesTellHowItEnded(int code, string line, object ending) =>
        Assert.That(ChildResult.Of(code, [line]), Is.EqualTo(ending));

    [Test]
    public void ALogHasAnEndAndSaysSo()
    {
        using (var log = new ChildLog(LogFile))
            for (int i = 0; i < ChildLog.MostLines + 5; i++) log.Add("line");

        string[] lines = File.ReadAllLines(LogFile);
        Assert.That(lines, Has.Length.EqualTo(ChildLog.MostLines + 1));
        Assert.That(lines[^1], Does.Contain("left out"));
    }

    private ChildResult Run(string fault, TimeSpan limit)
    {
        using var log = new ChildLog(LogFile);
        return Child.Run(Fault(fault), limit, log, default);
    }

    private static ProcessStartInfo Fault(string fault) =>
        new("dotnet", [Path.Combine(AppContext.BaseDirectory, "sphmeasure.dll"), FakeFault.Word, fault]);
}
