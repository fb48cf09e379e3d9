using Headless.Engine;

namespace UnityEngine.Profiling;

/// <summary>Values of the last whole frame.</summary>
public sealed class Recorder
{
    readonly ProfilerMarkerData? m_Data;

    internal Recorder(ProfilerMarkerData? data)
    {
        m_Data = data;
        if (data is not null) data.HasRecorder = true;
    }

    public static Recorder Get(string samplerName) => new(ProfilerMarkerData.Of(samplerName));

    public bool isValid => m_Data is not null;
    public bool enabled { get; set; } = true;
    public long elapsedNanoseconds => enabled ? m_Data?.LastCpuNanoseconds ?? 0 : 0;
    public long gpuElapsedNanoseconds => enabled ? m_Data?.LastGpuNanoseconds ?? 0 : 0;
    public int sampleBlockCount => enabled ? m_Data?.LastCpuCount ?? 0 : 0;
    public int gpuSampleBlockCount => enabled ? m_Data?.LastGpuCount ?? 0 : 0;

    public void FilterToCurrentThread() { }
    public void CollectFromAllThreads() { }
}
