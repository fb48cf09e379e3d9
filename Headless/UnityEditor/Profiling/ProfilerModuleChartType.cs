namespace Unity.Profiling.Editor;

public enum ProfilerModuleChartType
{
    Line = 0,
    StackedArea = 1,
    StackedTimeArea = 2,
}
