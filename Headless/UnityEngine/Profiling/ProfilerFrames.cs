using System;
using System.Collections.Generic;

namespace Headless.Engine;

/// <summary>Closes the frame for all markers and hands its values to running recorders.</summary>
static class ProfilerFrames
{
    static readonly object s_Lock = new();
    static readonly List<ProfilerRecorderData> s_Recorders = new();
    static bool s_Attached;

    /// <summary>Finished device scopes appear as the GPU values of the marker of the same name.</summary>
    public static void BeginFrame()
    {
        if (s_Attached) return;
        s_Attached = true;
        GpuTimings.Finished += static (marker, milliseconds) => ProfilerMarkerData.Of(marker).AddGpu((long)Math.Round(milliseconds * 1e6), 1);
    }

    public static void Add(ProfilerRecorderData recorder)
    {
        lock (s_Lock) s_Recorders.Add(recorder);
    }

    public static void Remove(ProfilerRecorderData recorder)
    {
        lock (s_Lock) s_Recorders.Remove(recorder);
    }

    public static void EndFrame()
    {
        foreach (ProfilerMarkerData marker in ProfilerMarkerData.All) marker.EndFrame();
        ProfilerCounterValue.EndFrame();
        lock (s_Lock)
            foreach (ProfilerRecorderData recorder in s_Recorders) recorder.Sample();
    }
}
