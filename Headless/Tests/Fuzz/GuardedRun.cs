using System.Diagnostics;
using System.Runtime.InteropServices;
using Headless.Files;

namespace Headless.Tests.Fuzz;

/// <summary>Runs an import with bounds on time and memory, on a thread with the stack of a main thread.</summary>
internal static class GuardedRun
{
    private const double MostSeconds = 5;
    private const long MostBytes = 1L << 30;
    private const int Stack = 8 << 20;
    private const int MostMessage = 1100;

    /// <summary>Wall time after which it hangs, however busy the machine.</summary>
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(90);

    /// <param name="Problem">Why it fails the test; null when it was imported or refused as it should be.</param>
    /// <param name="Refusal">The message of a refusal.</param>
    public sealed record Result(string? Problem, string? Refusal, double Seconds, long Bytes);

    public static Result Of(Action import)
    {
        Exception? thrown = null;
        double seconds = 0;
        long bytes = 0;
        var thread = new Thread(() =>
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            double start = ProcessorSeconds();
            try
            {
                import();
            }
            catch (Exception e)
            {
                thrown = e;
            }
            seconds = ProcessorSeconds() - start;
            bytes = GC.GetAllocatedBytesForCurrentThread() - before;
        }, Stack)
        { IsBackground = true };
        thread.Start();
        if (!thread.Join(Patience)) return new Result($"hangs: not done after {Patience.TotalSeconds} s", null, Patience.TotalSeconds, 0);
        string? problem = thrown is null ? null : Check(thrown);
        if (seconds > MostSeconds) problem ??= $"took {seconds:0.0} s of processor time";
        if (bytes > MostBytes) problem ??= $"allocated {bytes >> 20} MiB";
        return new Result(problem, thrown?.Message, seconds, bytes);
    }

    private static string? Check(Exception thrown)
    {
        if (thrown is not BadFileException) return $"an exception that is no message for a user: {thrown}";
        string message = thrown.Message;
        if (message.Contains('\n')) return $"a message of several lines: {message}";
        if (message.Length > MostMessage) return $"a message of {message.Length} characters";
        if (message.Contains(" at Headless.", StringComparison.Ordinal)) return $"a stack trace: {message}";
        return message.Contains('/') || message.Contains(".shader") || message.Contains(".compute") ? null : $"a message that names no file: {message}";
    }

    private static double ProcessorSeconds()
    {
        if (!OperatingSystem.IsLinux()) return Stopwatch.GetElapsedTime(0).TotalSeconds;
        ClockGetTime(ThreadClock, out TimeSpec time);
        return time.Seconds + 1e-9 * time.Nanoseconds;
    }

    private const int ThreadClock = 3;

    private struct TimeSpec
    {
        public long Seconds, Nanoseconds;
    }

    [DllImport("libc", EntryPoint = "clock_gettime")]
    private static extern int ClockGetTime(int clock, out TimeSpec time);
}
