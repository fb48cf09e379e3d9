using System;

namespace Unity.Profiling.LowLevel;

[Flags]
public enum MarkerFlags : ushort
{
    Default = 0,
    Script = 2,
    AvailabilityEditor = 4,
    AvailabilityNonDevelopment = 8,
    Warning = 16,
    ScriptInvoke = 32,
    ScriptDeepProfiler = 64,
    Counter = 128,
    SampleGPU = 256,
}
