using Headless.Bench.Model;
using NUnit.Framework;

namespace Headless.Tests.Bench;

/// <summary>The arithmetic of the model, on the tables that are committed.</summary>
public sealed class StepModelTests
{
    private static readonly double[] Sizes = [512, 65536, 262144, 1048576];

    private static string Root => Conformance.ReleaseBuildTests.FindUp("Headless/Play.slnx");

    private readonly ModelTables tables = new(Root);

    [Test]
    public void EachCardsStepsHaveABoundThatIsTheLargestPart()
    {
        foreach (NamedGpu gpu in tables.Gpus)
            foreach (double kappa in tables.Kappas)
                foreach (ModelStep step in tables.Steps)
                    foreach (double n in Sizes)
                    {
                        StepCost cost = tables.Model(kappa).Time(gpu, step, n);
                        double largest = cost.Bound switch { "issue" => cost.Issue, "chain" => cost.Chain, "memory" => cost.Memory, _ => cost.Dispatches };
                        Assert.That(largest, Is.GreaterThanOrEqualTo(cost.Total / 4), $"{step.Name} of {gpu.Name}");
                        Assert.That(largest, Is.GreaterThan(0).And.LessThan(1));
                    }
    }

    [Test]
    public void AMeanLiesBetweenItsStepsByTheirNumbers()
    {
        StepModel model = tables.Model(2.25);
        foreach (NamedGpu gpu in tables.Gpus)
        {
            double rebuilt = model.Time(gpu, StepModel.Rebuilt, 65536).Total, reused = model.Time(gpu, StepModel.Reused, 65536).Total;
            Assert.That(model.Time(gpu, "Standard mean of 8", 65536).Total, Is.EqualTo((rebuilt + 7 * reused) / 8).Within(1e-12));
            Assert.That(model.Time(gpu, "Standard mean of 16", 65536).Total, Is.EqualTo((rebuilt + 15 * reused) / 16).Within(1e-12));
        }
    }

    [Test]
    public void MoreNeighboursTakeLongerAndLongerLists()
    {
        ModelStep reused = tables.Steps.First(s => s.Name == StepModel.Reused);
        double ratio = tables.Waves(2.25).First().Neighbours / tables.Waves(2).First().Neighbours;

        Assert.That(tables.Model(2.25).ListBytes(reused), Is.EqualTo(ratio * reused.ListBytes).Within(1e-9));
        Assert.That(tables.Model(2.25, 80).ListBytes(reused), Is.EqualTo(2 * tables.Model(2.25, 40).ListBytes(reused)).Within(1e-9));
        foreach (NamedGpu gpu in tables.Gpus)
            Assert.That(tables.Model(2.25).Time(gpu, reused, 65536).Total, Is.GreaterThan(tables.Model(2).Time(gpu, reused, 65536).Total), gpu.Name);
    }

    [Test]
    public void MeasuredTimesAreThoseOfTheBenchAndTheDoubtSpansTheirRatios()
    {
        var measured = new MeasuredSteps(tables);
        HeldEstimate rebuilt = measured.Steps.Single(s => s is { Step: StepModel.Rebuilt, Kappa: 2.25, Particles: 1048576 });
        ModelRow row = tables.Measured("solver").Single(r => r.Text("config") == "standard_2.25" && r.Number("particles") == 1048576);

        Assert.That(rebuilt.Measured, Is.EqualTo(1e-3 * row.Number("gpu_ms_median")));
        Assert.That(rebuilt.Ratio, Is.EqualTo(rebuilt.Measured / rebuilt.Estimated.Total));
        // Means of any number, those that were measured too, lie within the doubt of their two kinds of steps.
        Doubt doubt = measured.Doubt;
        var standard = measured.Steps.Where(s => s.Step.StartsWith("Standard", StringComparison.Ordinal) && s.Particles >= 16384).ToArray();
        Assert.That(standard, Has.Length.GreaterThan(20));
        foreach (HeldEstimate held in standard) Assert.That(held.Ratio, Is.InRange(doubt.Low - 1e-9, doubt.High + 1e-9), held.Step);
    }

    [Test]
    public void ReusedStepsAndARebuiltOneMakeTheStepsThatRanTogether()
    {
        var measured = new MeasuredSteps(tables);
        double Of(string step) => measured.Steps.Single(s => s.Step == step && s is { Kappa: 2, Particles: 65536 }).Measured;

        Assert.That(Of("Standard mean of 3"), Is.EqualTo((Of(StepModel.Rebuilt) + 2 * Of(StepModel.Reused)) / 3).Within(1e-10));
    }

    [Test]
    public void PartsOfARebuiltStepAddUpToIt()
    {
        var measured = new MeasuredSteps(tables);
        var parts = measured.Passes().Where(p => p is { Kappa: 2, Particles: 262144 }).ToArray();
        HeldEstimate step = measured.Steps.Single(s => s is { Step: StepModel.Rebuilt, Kappa: 2, Particles: 262144 });

        Assert.That(parts.Sum(p => p.Measured), Is.EqualTo(step.Measured).Within(1e-10));
        Assert.That(parts.Sum(p => p.Estimated.Total), Is.EqualTo(step.Estimated.Total).Within(1e-10));
    }
}
