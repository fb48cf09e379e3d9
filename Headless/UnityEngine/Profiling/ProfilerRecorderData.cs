using System;
using System.Collections.Generic;
using Unity.Profiling;

namespace Headless.Engine;

/// <summary>One recorder: a marker's time (or a named counter) sampled at the end of each frame into a ring.</summary>
sealed class ProfilerRecorderData(string statName, int capacity, ProfilerRecorderOptions options)
{
    readonly List<ProfilerRecorderSample> m_Samples = new();

    public int Capacity { get; } = Math.Max(1, capacity);
    public IReadOnlyList<ProfilerRecorderSample> Samples => m_Samples;
    public bool IsRunning { get; private set; }
    public bool WrappedAround { get; private set; }
    public bool IsCounter => ProfilerCounters.Has(statName);
    public bool IsValid => IsCounter || ProfilerMarkerData.Find(statName) is not null;
    public ProfilerMarkerDataUnit Unit => !IsCounter ? ProfilerMarkerDataUnit.TimeNanoseconds : ProfilerCounterValue.Find(statName)?.Unit ?? ProfilerMarkerDataUnit.Undefined;
    public bool ListensToGpu(string marker) => Gpu && marker == statName;
    bool Gpu => (options & ProfilerRecorderOptions.GpuRecorder) != 0;

    public long CurrentValue => IsCounter ? ProfilerCounters.Read(statName) : ProfilerMarkerData.Find(statName)?.CurrentCpuNanoseconds ?? 0;

    public void Start()
    {
        if (IsRunning) return;
        IsRunning = true;
        ProfilerFrames.Add(this);
    }

    public void Stop()
    {
        if (!IsRunning) return;
        IsRunning = false;
        ProfilerFrames.Remove(this);
    }

    public void Reset()
    {
        m_Samples.Clear();
        WrappedAround = false;
    }

    public void Sample()
    {
        ProfilerRecorderSample sample;
        if (IsCounter)
        {
            sample = new ProfilerRecorderSample(ProfilerCounters.Read(statName), 1);
        }
        else
        {
            ProfilerMarkerData? marker = ProfilerMarkerData.Find(statName);
            sample = marker is null ? default
                : Gpu ? new ProfilerRecorderSample(marker.LastGpuNanoseconds, marker.LastGpuCount)
                : new ProfilerRecorderSample(marker.LastCpuNanoseconds, marker.LastCpuCount);
        }
        if (m_Samples.Count == Capacity)
        {
            WrappedAround = true;
            if ((options & ProfilerRecorderOptions.WrapAroundWhenCapacityReached) == 0) return;
            m_Samples.RemoveAt(0);
        }
        m_Samples.Add(sample);
    }
}
