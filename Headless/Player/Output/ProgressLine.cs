using System.Diagnostics;
using System.Globalization;

namespace Headless.Player.Output;

/// <summary>One live line on a terminal; a plain line every few seconds elsewhere.</summary>
public sealed class ProgressLine(TextWriter output, bool terminal, int frames)
{
    private const int BarCells = 24;
    private readonly Stopwatch clock = Stopwatch.StartNew();
    private TimeSpan last = TimeSpan.MinValue;
    private double smoothed;

    public void Show(int done, double simulated, double frameMilliseconds)
    {
        smoothed = smoothed == 0 ? frameMilliseconds : 0.8 * smoothed + 0.2 * frameMilliseconds;
        TimeSpan now = clock.Elapsed;
        bool due = last == TimeSpan.MinValue || now - last > TimeSpan.FromSeconds(terminal ? 0.1 : 10);
        if (!due && done != frames) return;
        last = now;
        if (terminal) output.Write("\r\x1b[2K" + Line(done, simulated));
        else output.WriteLine(Line(done, simulated));
        output.Flush();
    }

    /// <summary>Ends the live line, so that what follows begins on its own.</summary>
    public void End()
    {
        if (terminal && last != TimeSpan.MinValue) output.WriteLine();
        last = TimeSpan.MinValue;
    }

    internal string Line(int done, double simulated)
    {
        double share = (double)done / frames;
        int filled = (int)(share * BarCells);
        string bar = terminal ? new string('█', filled) + new string('░', BarCells - filled) + " " : "";
        var eta = TimeSpan.FromMilliseconds(smoothed * (frames - done));
        return string.Create(CultureInfo.InvariantCulture, $"{bar}{share,4:P0}  frame {done}/{frames}  {simulated:0.00} s simulated  {smoothed:0} ms/frame  {(int)eta.TotalMinutes}:{eta.Seconds:00} left");
    }
}
