using System;
using System.Collections.Generic;
using Headless.Engine;

namespace UnityEngine.Profiling;

public sealed class Profiler
{
    [ThreadStatic] static Stack<ProfilerMarkerData>? s_Open;

    Profiler() { }

    public static bool supported => true;
    public static bool enabled { get; set; } = true;

    public static void BeginSample(string name)
    {
        ProfilerMarkerData data = ProfilerMarkerData.Of(name);
        (s_Open ??= new Stack<ProfilerMarkerData>()).Push(data);
        data.Begin();
    }

    public static void BeginSample(string name, Object targetObject) => BeginSample(name);

    public static void EndSample()
    {
        if (s_Open is { Count: > 0 }) s_Open.Pop().End();
    }

    public static long GetTotalAllocatedMemoryLong() => Environment.WorkingSet;
    public static long GetTotalReservedMemoryLong() => Environment.WorkingSet;
    public static long GetMonoUsedSizeLong() => GC.GetTotalMemory(false);
    public static long GetMonoHeapSizeLong() => GC.GetGCMemoryInfo().HeapSizeBytes;
    public static long GetAllocatedMemoryForGraphicsDriver() => ProfilerCounters.Read("Gfx Used Memory");
}
