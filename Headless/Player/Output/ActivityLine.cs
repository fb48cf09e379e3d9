using System.Diagnostics;
using System.Globalization;

namespace Headless.Player.Output;

/// <summary>
/// What the player is doing, once it takes longer than two seconds: one live line on a terminal, a plain line every ten
/// seconds elsewhere. The main thread need not come back for it to be shown.
/// </summary>
public sealed class ActivityLine : IDisposable
{
    private static readonly TimeSpan Silence = TimeSpan.FromSeconds(2);
    private readonly TextWriter output;
    private readonly bool terminal;
    private readonly TimeSpan pause;
    private readonly Timer timer;
    private readonly Lock gate = new();
    private readonly Stopwatch sinceBegin = new(), sinceShown = new();
    private string what = "";
    private bool open;

    public ActivityLine(TextWriter output, bool terminal)
    {
        (this.output, this.terminal) = (output, terminal);
        pause = TimeSpan.FromSeconds(terminal ? 0.25 : 10);
        var beat = TimeSpan.FromMilliseconds(250);
        timer = new Timer(_ => Tick(), null, beat, beat);
    }

    public bool IsTerminal => terminal;

    /// <summary>More about the activity, such as the shader that is compiled; null for nothing.</summary>
    public Func<string?>? Detail { get; set; }

    /// <summary>What is done from here on.</summary>
    public void Begin(string activity)
    {
        lock (gate)
        {
            what = activity;
            sinceBegin.Restart();
        }
    }

    /// <summary>Shows a line now, unless one was shown a moment ago.</summary>
    public void Show(string line, bool last)
    {
        lock (gate)
        {
            sinceBegin.Restart();
            if (sinceShown.IsRunning && sinceShown.Elapsed < pause && !last) return;
            Write(line);
        }
    }

    /// <summary>A whole line, between two live ones.</summary>
    public void Say(string line)
    {
        lock (gate)
        {
            if (open) output.Write("\r\x1b[2K");
            open = false;
            output.WriteLine(line);
            output.Flush();
        }
    }

    /// <summary>Ends the live line, so that what follows begins on its own.</summary>
    public void Break()
    {
        lock (gate)
        {
            if (open) output.WriteLine();
            open = false;
        }
    }

    /// <summary>Nothing more is shown.</summary>
    public void End()
    {
        lock (gate) what = "";
        Break();
    }

    public void Dispose()
    {
        timer.Dispose();
        Break();
    }

    private void Tick()
    {
        lock (gate)
        {
            if (what.Length == 0 || sinceBegin.Elapsed < Silence || sinceShown.IsRunning && sinceShown.Elapsed < pause) return;
            string detail = Detail?.Invoke() is { } more ? ", " + more : "";
            TimeSpan time = sinceBegin.Elapsed;
            Write(string.Create(CultureInfo.InvariantCulture, $"{what}{detail}, {(int)time.TotalMinutes}:{time.Seconds:00} so far"));
        }
    }

    private void Write(string line)
    {
        sinceShown.Restart();
        if (terminal) output.Write("\r\x1b[2K" + line);
        else output.WriteLine(line);
        output.Flush();
        open = terminal;
    }
}
