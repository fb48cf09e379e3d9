using Unity.Profiling;
#if ENABLE_PROFILER
using Unity.Profiling.LowLevel;
using Unity.Profiling.LowLevel.Unsafe;
#endif

namespace SphFluid
{
    /// <summary>
    /// A number of the Profiler: added up during a frame, taken at its end, zero at the start of the next one. The package
    /// com.unity.profiling.core has it as ProfilerCounterValue; this needs no package. Where Unity has no profiler, in release builds, it
    /// counts nothing.
    /// </summary>
    internal readonly struct FrameCounter
    {
#if ENABLE_PROFILER
        private readonly unsafe long* value;
#endif

        /// <summary>Makes it known to the Profiler.</summary>
        /// <param name="category">Where it is listed.</param>
        /// <param name="name">Its name there; of two with the same name one is shown.</param>
        /// <param name="unit">What it counts.</param>
        public unsafe FrameCounter(ProfilerCategory category, string name, ProfilerMarkerDataUnit unit)
        {
#if ENABLE_PROFILER
            value = (long*)ProfilerUnsafeUtility.CreateCounterValue(out _, name, category, MarkerFlags.Default,
                (byte)ProfilerMarkerDataType.Int64, (byte)unit,
                sizeof(long), ProfilerCounterOptions.FlushOnEndOfFrame | ProfilerCounterOptions.ResetToZeroOnFlush);
#endif
        }

        /// <summary>Adds to this frame's number.</summary>
        public unsafe void Add(long amount)
        {
#if ENABLE_PROFILER
            if (value != null) *value += amount;
#endif
        }
    }
}
