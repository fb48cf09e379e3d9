using System;
using System.Collections.Generic;

namespace Headless.Engine;

/// <summary>Closes the frame for all markers and hands its values to running recorders.</summary>
static class ProfilerFrames
{
    static readonly object s_Lock = new();
    static readonly List<ProfilerRecorderData> s_Recorders = new();

    /// <summary>Whether anything asks for the GPU times of a marker: no others are taken.</summary>
    public static bool ListenToGpu(string marker)
    {
        lock (s_Lock)
            if (s_Recorders.Exists(r => r.ListensToGpu(marker))) return true;
        return ProfilerMarkerData.Find(marker) is { HasRecorder: true };
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
