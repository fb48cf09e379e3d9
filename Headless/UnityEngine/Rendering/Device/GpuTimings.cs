using System.Collections.Generic;
using System;
using Headless.Vulkan;

namespace Headless.Engine;

/// <summary>
/// GPU milliseconds by marker name, as far as the device has finished them. A timestamp is work between the passes for a device, so
/// markers that nothing listens to are not timed.
/// </summary>
internal static class GpuTimings
{
    private static readonly Dictionary<string, (double Milliseconds, int Count)> Frame = new(StringComparer.Ordinal);
    private static readonly Dictionary<string, (double Milliseconds, int Count)> Totals = new(StringComparer.Ordinal);

    /// <summary>Scopes that were finished since the last collection: name, summed milliseconds, how many.</summary>
    public static IReadOnlyDictionary<string, (double Milliseconds, int Count)> LastFrame => Frame;

    /// <summary>Since the start or the last <see cref="Reset"/>.</summary>
    public static IReadOnlyDictionary<string, (double Milliseconds, int Count)> Total => Totals;

    /// <summary>Milliseconds of all outermost scopes in the last collection.</summary>
    public static double FrameMilliseconds { get; private set; }

    public static double TotalMilliseconds { get; private set; }

    /// <summary>Receives each finished scope by name with its milliseconds: all markers are timed while anything waits for it.</summary>
    public static event Action<string, double>? Finished;

    /// <summary>Opens a marker's scope where something listens; what it returns goes to <see cref="End"/>.</summary>
    public static int Begin(string marker) =>
        Finished is not null || ProfilerFrames.ListenToGpu(marker) ? GraphicsDevice.Recorder.BeginTimer(marker) : 0;

    public static void End(int scope)
    {
        if (scope != 0) GraphicsDevice.Recorder.EndTimer(scope);
    }

    public static void Collect()
    {
        Frame.Clear();
        FrameMilliseconds = 0;
        foreach (TimerResult result in GraphicsDevice.Device.CollectTimers())
        {
            Add(Frame, result);
            Add(Totals, result);
            if (result.Depth == 0)
            {
                FrameMilliseconds += result.Milliseconds;
                TotalMilliseconds += result.Milliseconds;
            }

            ProfilerMarkerData.Of(result.Name).AddGpu((long)Math.Round(result.Milliseconds * 1e6), 1);
            Finished?.Invoke(result.Name, result.Milliseconds);
        }
    }

    public static void Reset()
    {
        Frame.Clear();
        Totals.Clear();
        FrameMilliseconds = TotalMilliseconds = 0;
    }

    private static void Add(Dictionary<string, (double Milliseconds, int Count)> sums, TimerResult result)
    {
        (double milliseconds, int count) = sums.GetValueOrDefault(result.Name);
        sums[result.Name] = (milliseconds + result.Milliseconds, count + 1);
    }
}
