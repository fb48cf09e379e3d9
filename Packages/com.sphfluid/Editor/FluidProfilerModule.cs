using System;
using System.Linq;
using Unity.Profiling.Editor;

namespace SphFluid.Editor
{
    /// <summary>The module "SPH Fluid" of the Profiler window: a chart of the package's counters.</summary>
    [Serializable]
    [ProfilerModuleMetadata("SPH Fluid")]
    public sealed class FluidProfilerModule : ProfilerModule
    {
        /// <summary>The module, by the Profiler window.</summary>
        public FluidProfilerModule() : base(Counters(), ProfilerModuleChartType.Line, new[] { FluidProfiler.Category })
        {
        }

        /// <summary>The counters, in the order of the chart.</summary>
        internal static ProfilerCounterDescriptor[] Counters() =>
            FluidProfiler.Names.Select(name => new ProfilerCounterDescriptor(name, FluidProfiler.Category)).ToArray();
    }
}
