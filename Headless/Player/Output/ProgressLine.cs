using System.Globalization;

namespace Headless.Player.Output;

/// <summary>How many frames are done and how long the rest will take.</summary>
public sealed class ProgressLine(ActivityLine activity, int frames)
{
    private const int BarCells = 24;
    private double smoothed;

    public void Begin(int frame) => activity.Begin(string.Create(CultureInfo.InvariantCulture, $"frame {frame + 1}/{frames}"));

    public void Show(int done, double simulated, double frameMilliseconds)
    {
        // The first frame also compiles, imports and starts: it says little about the others.
        smoothed = done <= 2 || smoothed == 0 ? frameMilliseconds : 0.8 * smoothed + 0.2 * frameMilliseconds;
        activity.Show(Line(done, simulated), done == frames);
    }

    internal string Line(int done, double simulated)
    {
        double share = (double)done / frames;
        int filled = (int)(share * BarCells);
        string bar = activity.IsTerminal ? new string('█', filled) + new string('░', BarCells - filled) + " " : "";
        var eta = TimeSpan.FromMilliseconds(smoothed * (frames - done));
        string left = done == 1 && frames > 1 ? "" : string.Create(CultureInfo.InvariantCulture, $"  {(int)eta.TotalMinutes}:{eta.Seconds:00} left");
        return string.Create(CultureInfo.InvariantCulture, $"{bar}{share,4:P0}  frame {done}/{frames}  {simulated:0.00} s simulated  {smoothed:0} ms/frame{left}");
    }
}
