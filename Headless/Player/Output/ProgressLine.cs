using System.Globalization;

namespace Headless.Player.Output;

/// <summary>How many frames are done and how long the rest will take; once that is known, how long the whole does.</summary>
public sealed class ProgressLine(ActivityLine activity, int frames, string picture)
{
    private const int BarCells = 24;

    /// <summary>Shorter plays are over before one has read it.</summary>
    private static readonly TimeSpan WorthSaying = TimeSpan.FromSeconds(15);

    private readonly RemainingTime remaining = new(frames);
    private int finished;
    private bool said;

    /// <param name="frame">From 0.</param>
    /// <param name="seconds">Time since the start of the play.</param>
    public void Begin(int frame, double seconds) => activity.Begin(string.Create(CultureInfo.InvariantCulture, $"frame {frame + 1}/{frames}{Left(seconds)}"));

    /// <summary>Takes note of frames that the device has finished.</summary>
    public void Finished(int count, double seconds)
    {
        finished = Math.Max(finished, count);
        remaining.Add(count, seconds);
    }

    /// <param name="simulated">Simulated seconds.</param>
    /// <param name="seconds">Time since the start of the play.</param>
    /// <param name="last">Whether it is over.</param>
    public void Show(double simulated, double seconds, bool last = false)
    {
        if (!said && remaining.Left(seconds) is { } left)
        {
            said = true;
            var whole = TimeSpan.FromSeconds(seconds) + left;
            if (whole > WorthSaying) activity.Say($"{RemainingTime.About(whole)} for {frames} frames{picture}; {RemainingTime.About(left)} left");
        }
        activity.Show(Line(simulated, seconds), last);
    }

    internal string Line(double simulated, double seconds)
    {
        double share = (double)finished / frames;
        int filled = (int)(share * BarCells);
        string bar = activity.IsTerminal ? new string('█', filled) + new string('░', BarCells - filled) + " " : "";
        string each = remaining.SecondsPerFrame is { } mean ? $"  {1000 * mean:0} ms/frame" : "";
        return string.Create(CultureInfo.InvariantCulture, $"{bar}{share,4:P0}  frame {finished}/{frames}  {simulated:0.00} s simulated{each}{Left(seconds)}");
    }

    private string Left(double seconds) =>
        finished < frames && remaining.Left(seconds) is { } time ? $"  {(int)time.TotalMinutes}:{time.Seconds:00} left" : "";
}
