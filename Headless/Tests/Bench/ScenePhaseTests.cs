using Headless.Bench;
using Headless.Bench.Scene;
using NUnit.Framework;

namespace Headless.Tests.Bench;

public sealed class ScenePhaseTests
{
    [Test]
    public void ASecondAtThirtyFramesIsFramesOneToThirty()
    {
        ScenePhase phase = ScenePhase.ParseList("--phases", "0-1")[0];

        Assert.That(Enumerable.Range(0, 40).Where(f => phase.Has(f, 30)), Is.EqualTo(Enumerable.Range(1, 30)));
    }

    [Test]
    public void PhasesThatTouchShareNoFrame()
    {
        ScenePhase[] phases = ScenePhase.ParseList("--phases", "0.1-0.3,0.3-0.5");

        Assert.That(Enumerable.Range(0, 40).Count(f => phases.Count(p => p.Has(f, 30)) > 1), Is.Zero);
        Assert.That(phases.Select(p => p.Name), Is.EqualTo(new[] { "0.1-0.3", "0.3-0.5" }));
    }

    [TestCase("")]
    [TestCase("1")]
    [TestCase("1-0")]
    [TestCase("0-1-2")]
    [TestCase("0-2,1-3")]
    [TestCase("a-b")]
    [TestCase("0--1")]
    public void AnythingElseNamesTheFlag(string text) =>
        Assert.That(() => ScenePhase.ParseList("--phases", text), Throws.TypeOf<UsageException>().With.Message.Contains("--phases"));

    [TestCase("MoveParticles", PassGroup.Solver)]
    [TestCase("ScanCells", PassGroup.Solver)]
    [TestCase("PrepareSurfaceParticles", PassGroup.Surface)]
    [TestCase("EmitBlocks", PassGroup.Surface)]
    [TestCase("SetMCGridDensityFactors", PassGroup.Surface)]
    [TestCase("Camera.Render", PassGroup.Drawing)]
    public void PassesHaveTheirPart(string pass, object part) => Assert.That(PassGroups.Of(pass), Is.EqualTo(part));
}
