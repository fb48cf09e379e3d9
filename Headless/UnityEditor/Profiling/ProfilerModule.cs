using System.Collections.Generic;

namespace Unity.Profiling.Editor;

/// <summary>There is no profiler window: a module is what it says of itself.</summary>
public abstract class ProfilerModule
{
    protected ProfilerModule(ProfilerCounterDescriptor[] chartCounters, ProfilerModuleChartType defaultChartType = ProfilerModuleChartType.Line,
        string[]? autoEnabledCategoryNames = null)
    {
        ChartCounters = chartCounters;
        AutoEnabledCategoryNames = autoEnabledCategoryNames ?? [];
    }

    internal IReadOnlyList<ProfilerCounterDescriptor> ChartCounters { get; }
    internal IReadOnlyList<string> AutoEnabledCategoryNames { get; }
}
