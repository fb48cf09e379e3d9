using System;
using System.Collections.Generic;
using Headless.Engine;

namespace Unity.Profiling;

/// <summary>Marker times in nanoseconds. With GpuRecorder, device time, counted in the frame in which its query was read.</summary>
public struct ProfilerRecorder : IDisposable
{
    ProfilerRecorderData? m_Data;

    public ProfilerRecorder(string statName, int capacity = 1, ProfilerRecorderOptions options = ProfilerRecorderOptions.Default)
    {
        m_Data = new ProfilerRecorderData(statName, capacity, options);
        if ((options & ProfilerRecorderOptions.StartImmediately) != 0) m_Data.Start();
    }

    public ProfilerRecorder(string categoryName, string statName, int capacity = 1, ProfilerRecorderOptions options = ProfilerRecorderOptions.Default)
        : this(statName, capacity, options) { }

    public ProfilerRecorder(ProfilerCategory category, string statName, int capacity = 1, ProfilerRecorderOptions options = ProfilerRecorderOptions.Default)
        : this(statName, capacity, options) { }

    public ProfilerRecorder(ProfilerMarker marker, int capacity = 1, ProfilerRecorderOptions options = ProfilerRecorderOptions.Default)
        : this(marker.Name ?? throw new ArgumentException("The marker was not created.", nameof(marker)), capacity, options) { }

    public static ProfilerRecorder StartNew(ProfilerCategory category, string statName, int capacity = 1, ProfilerRecorderOptions options = ProfilerRecorderOptions.Default) =>
        new(category, statName, capacity, options | ProfilerRecorderOptions.StartImmediately);

    public static ProfilerRecorder StartNew(ProfilerMarker marker, int capacity = 1, ProfilerRecorderOptions options = ProfilerRecorderOptions.Default) =>
        new(marker, capacity, options | ProfilerRecorderOptions.StartImmediately);

    public bool Valid => m_Data?.IsValid ?? false;
    public bool IsRunning => m_Data?.IsRunning ?? false;
    public bool WrappedAround => m_Data?.WrappedAround ?? false;
    public int Capacity => m_Data?.Capacity ?? 0;
    public int Count => m_Data?.Samples.Count ?? 0;
    public long CurrentValue => m_Data?.CurrentValue ?? 0;
    public double CurrentValueAsDouble => CurrentValue;
    public long LastValue => m_Data is { Samples.Count: > 0 } data ? data.Samples[^1].Value : 0;
    public double LastValueAsDouble => LastValue;
    public ProfilerMarkerDataUnit UnitType => m_Data?.Unit ?? ProfilerMarkerDataUnit.Undefined;

    public void Start() => m_Data?.Start();
    public void Stop() => m_Data?.Stop();
    public void Reset() => m_Data?.Reset();

    public ProfilerRecorderSample GetSample(int index) =>
        m_Data is { } data && (uint)index < (uint)data.Samples.Count ? data.Samples[index] : throw new IndexOutOfRangeException($"Index {index} is out of range of recorded samples.");

    public void CopyTo(List<ProfilerRecorderSample> outSamples, bool reset = false)
    {
        ArgumentNullException.ThrowIfNull(outSamples);
        outSamples.Clear();
        if (m_Data is not { } data) return;
        outSamples.AddRange(data.Samples);
        if (reset) data.Reset();
    }

    public ProfilerRecorderSample[] ToArray()
    {
        var list = new List<ProfilerRecorderSample>();
        CopyTo(list);
        return list.ToArray();
    }

    public void Dispose()
    {
        m_Data?.Stop();
        m_Data = null;
    }
}
