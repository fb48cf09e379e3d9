using System.Collections.Generic;
using System.Linq;

namespace Headless.Engine;

/// <summary>Which tests run, in what order, and when the run ends.</summary>
sealed record TestSelection
{
    /// <summary>See <see cref="TestFilter"/>; empty for everything. Not used with <see cref="Names"/>.</summary>
    public string Filter { get; init; } = "";

    /// <summary>Whole names of tests in the order in which they run; null for the order of the assemblies. Names of no test are passed over.</summary>
    public IReadOnlyList<string>? Names { get; init; }

    /// <summary>A filter that tests must pass besides; null for none.</summary>
    public string? Within { get; init; }

    /// <summary>Nothing runs after the first failure.</summary>
    public bool StopOnFail { get; init; }

    public IEnumerable<TestFilter> Filters() =>
        (Names is null ? [new TestFilter(Filter)] : Names.Select(TestFilter.Exactly)).Select(f => Within is null ? f : f.And(Within));
}
