using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Diagnostics;
using System.Threading;

namespace Headless.Engine;

/// <summary>Measurements under one marker name: CPU scopes of the running frame and the last whole one, and GPU time as it arrives.</summary>
sealed class ProfilerMarkerData(string name)
{
    static readonly ConcurrentDictionary<string, ProfilerMarkerData> s_Markers = new();

    readonly ThreadLocal<Stack<long>> m_Open = new(static () => new Stack<long>());
    long m_CpuTicks;
    int m_CpuCount;
    long m_GpuNanoseconds;
    int m_GpuCount;

    public string Name { get; } = name;

    /// <summary>Whether a script holds its <see cref="UnityEngine.Profiling.Recorder"/>.</summary>
    public bool HasRecorder { get; set; }
    public long LastCpuNanoseconds { get; private set; }
    public int LastCpuCount { get; private set; }
    public long LastGpuNanoseconds { get; private set; }
    public int LastGpuCount { get; private set; }

    public long CurrentCpuNanoseconds => ToNanoseconds(Interlocked.Read(ref m_CpuTicks));

    public static ICollection<ProfilerMarkerData> All => s_Markers.Values;
    public static ProfilerMarkerData Of(string name) => s_Markers.GetOrAdd(name, static n => new ProfilerMarkerData(n));
    public static ProfilerMarkerData? Find(string name) => s_Markers.GetValueOrDefault(name);

    public void Begin() => m_Open.Value!.Push(Stopwatch.GetTimestamp());

    public void End()
    {
        if (!m_Open.Value!.TryPop(out long start)) return;
        Interlocked.Add(ref m_CpuTicks, Stopwatch.GetTimestamp() - start);
        Interlocked.Increment(ref m_CpuCount);
    }

    public void AddGpu(long nanoseconds, int count)
    {
        Interlocked.Add(ref m_GpuNanoseconds, nanoseconds);
        Interlocked.Add(ref m_GpuCount, count);
    }

    public void EndFrame()
    {
        LastCpuNanoseconds = ToNanoseconds(Interlocked.Exchange(ref m_CpuTicks, 0));
        LastCpuCount = Interlocked.Exchange(ref m_CpuCount, 0);
        LastGpuNanoseconds = Interlocked.Exchange(ref m_GpuNanoseconds, 0);
        LastGpuCount = Interlocked.Exchange(ref m_GpuCount, 0);
    }

    static long ToNanoseconds(long ticks) => (long)(ticks * (1e9 / Stopwatch.Frequency));
}
