using System.Collections.Generic;
using System.Linq;
using NUnit.Framework.Interfaces;

namespace Headless.Engine;

/// <summary>Counts of a run. A run without a single executed test is a failure.</summary>
sealed class TestRunResult(IReadOnlyList<TestOutcome> outcomes, double seconds)
{
    public IReadOnlyList<TestOutcome> Outcomes { get; } = outcomes;
    public double Seconds { get; } = seconds;
    public int Passed => Count(TestStatus.Passed);
    public int Failed => Count(TestStatus.Failed);
    public int Skipped => Count(TestStatus.Skipped);
    public int Inconclusive => Count(TestStatus.Inconclusive);
    public bool Succeeded => Failed == 0 && Passed > 0;

    int Count(TestStatus status) => Outcomes.Count(o => o.Status == status);

    public override string ToString() =>
        $"{Passed} passed, {Failed} failed, {Skipped} skipped, {Inconclusive} inconclusive in {Seconds:0.0} s" + (Outcomes.Count == 0 ? " (no test was found)" : "");
}
