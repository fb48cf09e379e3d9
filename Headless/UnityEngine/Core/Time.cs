using System;
using Headless.Engine;

namespace UnityEngine;

public class Time
{
    public static float time => (float)timeAsDouble;
    public static double timeAsDouble => FrameClock.InFixedStep ? FrameClock.FixedTime : FrameClock.Time;
    public static float deltaTime => FrameClock.InFixedStep ? FrameClock.FixedDeltaTime : FrameClock.DeltaTime;
    public static float unscaledTime => (float)unscaledTimeAsDouble;
    public static double unscaledTimeAsDouble => FrameClock.InFixedStep ? FrameClock.FixedUnscaledTime : FrameClock.UnscaledTime;
    public static float unscaledDeltaTime => FrameClock.InFixedStep ? fixedUnscaledDeltaTime : FrameClock.UnscaledDeltaTime;
    public static float fixedTime => (float)FrameClock.FixedTime;
    public static double fixedTimeAsDouble => FrameClock.FixedTime;
    public static float fixedUnscaledTime => (float)FrameClock.FixedUnscaledTime;
    public static double fixedUnscaledTimeAsDouble => FrameClock.FixedUnscaledTime;
    public static float fixedUnscaledDeltaTime => FrameClock.TimeScale > 0f ? FrameClock.FixedDeltaTime / FrameClock.TimeScale : FrameClock.FixedDeltaTime;
    public static float smoothDeltaTime => FrameClock.SmoothDeltaTime;
    public static float timeSinceLevelLoad => (float)FrameClock.TimeSinceLevelLoad;
    public static double timeSinceLevelLoadAsDouble => FrameClock.TimeSinceLevelLoad;
    public static float realtimeSinceStartup => (float)FrameClock.Realtime;
    public static double realtimeSinceStartupAsDouble => FrameClock.Realtime;
    public static int frameCount => FrameClock.FrameCount;
    public static int renderedFrameCount => FrameClock.FrameCount;
    public static bool inFixedTimeStep => FrameClock.InFixedStep;

    public static float fixedDeltaTime
    {
        get => FrameClock.FixedDeltaTime;
        set => FrameClock.FixedDeltaTime = Mathf.Clamp(value, 0.0001f, 10f);
    }

    public static float maximumDeltaTime
    {
        get => FrameClock.MaximumDeltaTime;
        set => FrameClock.MaximumDeltaTime = Mathf.Max(value, FrameClock.FixedDeltaTime);
    }

    public static float maximumParticleDeltaTime { get; set; } = 0.03f;

    public static float timeScale
    {
        get => FrameClock.TimeScale;
        set
        {
            if (value < 0f || value > 100f || float.IsNaN(value))
            {
                Debug.LogError("Time.timeScale is out of range. When running in the editor this value needs to be less than or equal to 100.0");
                return;
            }
            FrameClock.TimeScale = value;
        }
    }

    public static float captureDeltaTime
    {
        get => FrameClock.CaptureDeltaTime;
        set => FrameClock.CaptureDeltaTime = MathF.Max(0f, value);
    }

    public static int captureFramerate
    {
        get => FrameClock.CaptureDeltaTime == 0f ? 0 : (int)MathF.Round(1f / FrameClock.CaptureDeltaTime);
        set => FrameClock.CaptureDeltaTime = value == 0 ? 0f : 1f / value;
    }
}
