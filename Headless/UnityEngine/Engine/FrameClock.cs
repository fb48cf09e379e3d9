using System.Diagnostics;

namespace Headless.Engine;

/// <summary>Dynamic and fixed time. A capture step makes every frame last that long, whatever it really took.</summary>
static class FrameClock
{
    static readonly Stopwatch s_Real = Stopwatch.StartNew();
    static double s_LastReal;
    static bool s_FirstFrame = true;
    static bool s_FirstFixedStep = true;
    static double s_LevelLoadTime;

    public static double Time { get; private set; }
    public static float DeltaTime { get; private set; } = 0.02f;
    public static double UnscaledTime { get; private set; }
    public static float UnscaledDeltaTime { get; private set; } = 0.02f;
    public static double FixedTime { get; private set; }
    public static double FixedUnscaledTime { get; private set; }
    public static float FixedDeltaTime { get; set; } = 0.02f;
    public static float MaximumDeltaTime { get; set; } = 1f / 3f;
    public static float TimeScale { get; set; } = 1f;
    public static float CaptureDeltaTime { get; set; }
    public static bool InFixedStep { get; private set; }
    public static int FrameCount { get; private set; }
    public static long FixedStepCount { get; private set; }
    public static float SmoothDeltaTime { get; private set; } = 0.02f;
    public static double TimeSinceLevelLoad => (InFixedStep ? FixedTime : Time) - s_LevelLoadTime;
    public static double Realtime => s_Real.Elapsed.TotalSeconds;

    public static void Reset()
    {
        Restart();
        FixedDeltaTime = 0.02f;
        MaximumDeltaTime = 1f / 3f;
        TimeScale = 1f;
        CaptureDeltaTime = 0f;
    }

    /// <summary>Time and frames begin at zero; the settings stay.</summary>
    public static void Restart()
    {
        s_FirstFrame = s_FirstFixedStep = true;
        Time = UnscaledTime = FixedTime = FixedUnscaledTime = s_LevelLoadTime = 0.0;
        DeltaTime = UnscaledDeltaTime = SmoothDeltaTime = 0.02f;
        InFixedStep = false;
        FrameCount = 0;
        FixedStepCount = 0;
        s_LastReal = Realtime;
    }

    public static void MarkLevelLoad() => s_LevelLoadTime = Time;

    public static void BeginFrame()
    {
        FrameCount++;
        double now = Realtime;
        float step = CaptureDeltaTime > 0f ? CaptureDeltaTime : (float)(now - s_LastReal);
        s_LastReal = now;
        if (s_FirstFrame)
        {
            // The first frame is at time zero; its delta is the step to come, or 0.02 s when that is unknown.
            s_FirstFrame = false;
            UnscaledDeltaTime = CaptureDeltaTime > 0f ? CaptureDeltaTime : 0.02f;
            DeltaTime = UnscaledDeltaTime * TimeScale;
            SmoothDeltaTime = DeltaTime;
            return;
        }
        UnscaledDeltaTime = step;
        UnscaledTime += step;
        DeltaTime = (CaptureDeltaTime > 0f ? step : System.Math.Min(step, MaximumDeltaTime)) * TimeScale;
        Time += DeltaTime;
        SmoothDeltaTime += (DeltaTime - SmoothDeltaTime) * 0.2f;
    }

    /// <summary>Starts the next fixed step if dynamic time has reached it; false returns to dynamic time.</summary>
    public static bool StepFixed()
    {
        bool due = TimeScale > 0f && (s_FirstFixedStep || FixedTime + FixedDeltaTime <= Time + 1e-9);
        InFixedStep = due;
        if (!due) return false;
        if (!s_FirstFixedStep)
        {
            FixedTime += FixedDeltaTime;
            FixedUnscaledTime += FixedDeltaTime / TimeScale;
        }
        s_FirstFixedStep = false;
        FixedStepCount++;
        return true;
    }
}
