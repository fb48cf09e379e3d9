using System.Text.Json;
using Headless.Player.Output;
using NUnit.Framework;

namespace Headless.Tests.Player;

public sealed class OutputFileTests
{
    private string folder = "";

    [SetUp]
    public void SetUp() => folder = Directory.CreateTempSubdirectory("player-output-").FullName;

    [TearDown]
    public void TearDown() => Directory.Delete(folder, recursive: true);

    [Test]
    public void PassesThatComeLateGetAColumnOfTheirOwn()
    {
        string path = Path.Combine(folder, "timings.csv");
        var timings = new TimingsFile(path);
        timings.AddFrame(0, 0, 12.5);
        timings.AddFrame(1, 1.0 / 30, 10);
        timings.AddGpu(0, 3, [("Step", 1), ("Step", 1), ("Draw", 1)]);
        timings.AddGpu(1, 4, [("Late, one", 4)]);
        timings.Save();
        Assert.That(File.ReadAllLines(path), Is.EqualTo(new[]
        {
            "frame,time_s,cpu_ms,gpu_ms,gpu_ms.Step,gpu_ms.Draw,\"gpu_ms.Late, one\"",
            "0,0,12.5,3,2,1,",
            "1,0.033333,10,4,,,4",
        }));
    }

    [Test]
    public void TheSummaryIsFlatJsonInOrder()
    {
        string path = Path.Combine(folder, "summary.json");
        SummaryFile.Write(path, [("device", "a \"b\""), ("frames", 3), ("wall_s", 1.23456789), ("nothing", null), ("bad", double.NaN)]);
        using JsonDocument json = JsonDocument.Parse(File.ReadAllText(path));
        Assert.That(json.RootElement.EnumerateObject().Select(p => p.Name), Is.EqualTo(new[] { "device", "frames", "wall_s", "nothing", "bad" }));
        Assert.That(json.RootElement.GetProperty("device").GetString(), Is.EqualTo("a \"b\""));
        Assert.That(json.RootElement.GetProperty("wall_s").GetDouble(), Is.EqualTo(1.234568));
        Assert.That(json.RootElement.GetProperty("bad").ValueKind, Is.EqualTo(JsonValueKind.Null));
    }

    [Test]
    public void FramesAreWrittenInTheBackground()
    {
        using var writer = new FrameWriter(folder);
        for (int i = 0; i < 9; i++) writer.Add(i, 5, 3, new byte[5 * 3 * 4]);
        writer.Finish();
        Assert.That(writer.Written, Is.EqualTo(9));
        Assert.That(Directory.GetFiles(folder).Select(Path.GetFileName).Order(), Is.EqualTo(Enumerable.Range(0, 9).Select(i => $"frame_{i:D5}.png")));
    }

    [Test]
    public void AFolderThatCannotBeWrittenIsReported()
    {
        using var writer = new FrameWriter(Path.Combine(folder, "missing"));
        writer.Add(0, 1, 1, new byte[4]);
        Assert.That(writer.Finish, Throws.InstanceOf<IOException>());
    }

    [Test]
    public void WhatCannotBeWrittenToItsEndLeavesWhatWasThereBefore()
    {
        string path = Path.Combine(folder, "a");
        for (int attempt = 0; attempt < 2; attempt++)
        {
            Assert.That(() => WholeFile.Write(path, stream =>
            {
                stream.Write(new byte[100_000]);
                throw new IOException("No space left on device");
            }), Throws.InstanceOf<IOException>());
            Assert.That(Directory.GetFiles(folder), Is.EqualTo(attempt == 0 ? [] : new[] { path }));
            WholeFile.WriteText(path, "before");
        }
        Assert.That(File.ReadAllText(path), Is.EqualTo("before"));
    }

    [Test]
    public void TheProgressLineTellsShareTimeAndRest()
    {
        var output = new StringWriter();
        using var activity = new ActivityLine(output, terminal: false);
        var progress = new ProgressLine(activity, frames: 90, "");
        for (int i = 0; i < 45; i++) progress.Finished(i + 1, 0.1 * (i + 1));
        progress.Show(simulated: 1.5, seconds: 4.5);
        Assert.That(output.ToString().TrimEnd(), Is.EqualTo("50 %  frame 45/90  1.50 s simulated  100 ms/frame  0:04 left").Or.EqualTo(" 50%  frame 45/90  1.50 s simulated  100 ms/frame  0:04 left"));
    }
}
