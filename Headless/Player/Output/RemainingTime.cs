namespace Headless.Player.Output;

/// <summary>
/// How long a play still takes, from the times at which the device had finished frames. Frame 0 compiles, imports and takes no steps, so it
/// is no measure of the others; frames are recorded ahead and arrive in bursts, so what counts is the time between arrivals, not the time
/// of a call. The last half of the frames counts: a splash costs more than the fall before it.
/// </summary>
public sealed class RemainingTime(int frames)
{
    /// <summary>Frames behind frame 0 before anything is said: the ring of submissions is full by then. Slow ones come one by one.</summary>
    private const int FewestFrames = 3;
    private const double SlowSeconds = 6;

    private readonly List<(int Finished, double Seconds)> arrivals = [];

    /// <summary>Takes note of frames that are finished.</summary>
    /// <param name="finished">All that are, frame 0 included.</param>
    /// <param name="seconds">Time since the start of the play.</param>
    public void Add(int finished, double seconds)
    {
        if (finished < 1 || arrivals.Count > 0 && finished <= arrivals[^1].Finished) return;
        arrivals.Add((finished, seconds));
    }

    /// <summary>Mean time of a frame; null while too few are finished.</summary>
    public double? SecondsPerFrame
    {
        get
        {
            if (arrivals.Count < 2) return null;
            var last = arrivals[^1];
            if (last.Finished - arrivals[0].Finished < FewestFrames && last.Seconds - arrivals[0].Seconds < SlowSeconds) return null;
            double half = 0.5 * (arrivals[0].Finished + last.Finished);
            int first = arrivals.FindLastIndex(a => a.Finished <= half && last.Finished - a.Finished >= FewestFrames);
            var begin = arrivals[Math.Max(0, first)];
            return (last.Seconds - begin.Seconds) / (last.Finished - begin.Finished);
        }
    }

    /// <summary>Time left; null while too few frames are finished.</summary>
    /// <param name="seconds">Time since the start of the play.</param>
    public TimeSpan? Left(double seconds) => SecondsPerFrame is { } each
        ? TimeSpan.FromSeconds(Math.Max(0, each * (frames - arrivals[^1].Finished) - (seconds - arrivals[^1].Seconds)))
        : null;

    /// <summary>A time as one says it: "about 40 s", "about 3 min", "about 1 h 20 min".</summary>
    public static string About(TimeSpan time)
    {
        if (time.TotalSeconds < 95) return $"about {Math.Max(5, 5 * (int)Math.Round(time.TotalSeconds / 5))} s";
        int minutes = (int)Math.Round(time.TotalMinutes);
        return minutes < 90 ? $"about {minutes} min" : $"about {minutes / 60} h{(minutes % 60 > 0 ? $" {minutes % 60} min" : "")}";
    }
}
