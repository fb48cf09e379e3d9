using Headless.Bench.Model;
using NUnit.Framework;

namespace Headless.Tests.Bench;

/// <summary>Parts of a frame by the ratio of two cards, and how many particles a frame has time for.</summary>
public sealed class FrameBudgetTests
{
    private readonly ModelTables tables = new(Conformance.ReleaseBuildTests.FindUp("Headless/Play.slnx"));

    [Test]
    public void TheMeasuredCardHasItsOwnTimes()
    {
        var parts = new FrameParts(tables, 1.5);
        foreach (FramePart part in tables.FrameParts)
            foreach (ModelRow row in tables.Measured("surface").Where(r => r.Text("config") == part.Config))
            {
                (double low, double high) = parts.Seconds(part, tables.Card, row.Number("particles"));
                Assert.That(low, Is.EqualTo(1e-3 * row.Number(part.Column)).Within(1e-12), part.Name);
                Assert.That(high, Is.EqualTo(low), part.Name);
            }
    }

    [Test]
    public void OthersHaveARangeAroundTheRatioOfTheResource()
    {
        var parts = new FrameParts(tables, 2);
        NamedGpu slow = tables.Card with { Name = "half", Schedulers = tables.Card.Schedulers / 2, Dispatch = 2 * tables.Card.Dispatch };
        FramePart count = tables.FrameParts.First(p => p.Resource == "dispatches"), field = tables.FrameParts.First(p => p.Name == "field");
        (double waiting, double work) = parts.Measured(field, 1048576);
        double counted = parts.Seconds(count, tables.Card, 65536).Low;

        Assert.That(parts.Seconds(count, slow, 65536).Low, Is.EqualTo(counted).Within(1e-12));
        Assert.That(parts.Seconds(count, slow, 65536).High, Is.EqualTo(4 * counted).Within(1e-12));
        Assert.That(parts.Seconds(field, slow, 1048576).High, Is.EqualTo(2 * (waiting + 2 * work)).Within(1e-12));
    }

    [Test]
    public void AnUnknownResourceIsNamed() => Assert.That(
        () => new FrameParts(tables, 1).Seconds(tables.FrameParts[0] with { Resource = "luck" }, tables.Gpus.First(g => g != tables.Card), 65536),
        Throws.TypeOf<UsageException>().With.Message.Contains("'luck'"));

    [Test]
    public void WhatFitsTakesTheWholeBudget()
    {
        StepModel model = tables.Model(2.25);
        var parts = new FrameParts(tables, 1);
        foreach (NamedGpu gpu in tables.Gpus)
            foreach (FrameSteps rate in FrameSteps.All)
            {
                (double low, double high) = new FrameBudget(model, parts).Particles(gpu, rate, new Doubt(1, 2));
                double taken = rate.At(high) * model.Time(gpu, rate.Step, high).Total + parts.Frame(gpu, high).Low;
                Assert.That(low, Is.GreaterThan(0).And.LessThan(high), gpu.Name);
                // Where lists outgrow a cache, times jump.
                Assert.That(taken, Is.LessThanOrEqualTo(FrameBudget.Seconds).And.GreaterThan(FrameBudget.Seconds / 2), gpu.Name);
            }
    }

    [Test]
    public void AMissingColumnIsNamed() => Assert.That(
        () => tables.Measured("surface")[0].Text("gpu_ms.luck"), Throws.TypeOf<UsageException>().With.Message.Contains("gpu_ms.luck"));
}
