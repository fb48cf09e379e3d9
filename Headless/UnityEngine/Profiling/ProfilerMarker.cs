using System;
using Headless.Engine;
using Unity.Profiling.LowLevel;

namespace Unity.Profiling;

public struct ProfilerMarker
{
    readonly ProfilerMarkerData? m_Data;

    public ProfilerMarker(string name) => m_Data = ProfilerMarkerData.Of(name);
    public ProfilerMarker(ProfilerCategory category, string name) : this(name) { }
    public ProfilerMarker(ProfilerCategory category, string name, MarkerFlags flags) : this(name) { }

    internal string? Name => m_Data?.Name;

    public IntPtr Handle => m_Data is null ? IntPtr.Zero : (IntPtr)System.Runtime.CompilerServices.RuntimeHelpers.GetHashCode(m_Data);

    public void Begin() => m_Data?.Begin();
    public void Begin(UnityEngine.Object contextUnityObject) => m_Data?.Begin();
    public void End() => m_Data?.End();

    public AutoScope Auto()
    {
        m_Data?.Begin();
        return new AutoScope(m_Data);
    }

    public struct AutoScope : IDisposable
    {
        readonly ProfilerMarkerData? m_Data;

        internal AutoScope(ProfilerMarkerData? data) => m_Data = data;

        public void Dispose() => m_Data?.End();
    }
}
