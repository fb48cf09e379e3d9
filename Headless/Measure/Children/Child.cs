using System.ComponentModel;
using System.Diagnostics;
using System.Runtime.InteropServices;

namespace Headless.Measure.Children;

/// <summary>
/// A child process with a limit of time. When that is over it is interrupted, so that it can end its files, then killed, and then left behind.
/// </summary>
internal static partial class Child
{
    private const int Sigint = 2;
    private static readonly TimeSpan grace = TimeSpan.FromSeconds(3), dying = TimeSpan.FromSeconds(5), look = TimeSpan.FromMilliseconds(50);

    /// <param name="log">Takes its lines.</param>
    /// <param name="stop">Ends it before its limit.</param>
    public static ChildResult Run(ProcessStartInfo start, TimeSpan limit, ChildLog log, CancellationToken stop)
    {
        start.RedirectStandardInput = start.RedirectStandardOutput = start.RedirectStandardError = true;
        var clock = Stopwatch.StartNew();
        Process process;
        try
        {
            process = Process.Start(start)!;
        }
        catch (Win32Exception e)
        {
            log.Add(e.Message);
            return new ChildResult(ChildEnding.Failed, null, log.Tail);
        }
        process.OutputDataReceived += (_, line) => log.Add(line.Data);
        process.ErrorDataReceived += (_, line) => log.Add(line.Data);
        process.BeginOutputReadLine();
        process.BeginErrorReadLine();
        process.StandardInput.Close();
        while (!process.WaitForExit(look))
        {
            if (clock.Elapsed >= limit || stop.IsCancellationRequested) return End(process, limit, log);
        }
        // What it left running may hold its output open.
        Task.Run(process.WaitForExit).Wait(dying);
        using (process) return new ChildResult(ChildResult.Of(process.ExitCode, log.Tail), process.ExitCode, log.Tail);
    }

    private static ChildResult End(Process process, TimeSpan limit, ChildLog log)
    {
        IReadOnlyList<string> tail = log.Tail;
        if (!OperatingSystem.IsWindows()) Signal(process.Id, Sigint);
        if (OperatingSystem.IsWindows() || !process.WaitForExit(grace)) Kill(process);
        bool ended = process.WaitForExit(dying);
        log.Add(FormattableString.Invariant($"{(ended ? "ended by the measurement" : "left behind: it could not be ended")} after its {limit.TotalSeconds:0} s"));
        return new ChildResult(ended ? ChildEnding.Stopped : ChildEnding.LeftBehind, null, tail);
    }

    private static void Kill(Process process)
    {
        try
        {
            process.Kill(entireProcessTree: true);
        }
        catch (Exception e) when (e is InvalidOperationException or Win32Exception or AggregateException)
        {
            // It has just ended, or cannot be ended, which shows.
        }
    }

    [LibraryImport("libc", EntryPoint = "kill")]
    private static partial int Signal(int process, int signal);
}
