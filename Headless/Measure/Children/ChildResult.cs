namespace Headless.Measure.Children;

/// <summary>What became of a child process.</summary>
/// <param name="Code">Exit code; null where it has none.</param>
/// <param name="Tail">Its last lines.</param>
internal sealed record ChildResult(ChildEnding Ending, int? Code, IReadOnlyList<string> Tail)
{
    private const int SignalCodes = 128, Killed = SignalCodes + 9, Interrupted = 130, Terminated = SignalCodes + 15;

    private static readonly string[] memoryWords = ["memory is full", "OutOfMemory", "out of memory", "OutOfDeviceMemory", "OutOfHostMemory"];

    /// <summary>Tells from an exit code and the last lines how a process ended that nobody stopped.</summary>
    public static ChildEnding Of(int code, IReadOnlyList<string> tail)
    {
        if (code == 0) return ChildEnding.Done;
        if (tail.Any(line => memoryWords.Any(word => line.Contains(word, StringComparison.OrdinalIgnoreCase)))) return ChildEnding.OutOfMemory;
        // What else kills a process without a word is the system, when its memory is full.
        if (code == Killed) return ChildEnding.OutOfMemory;
        // A negative code is an exception of Windows.
        return code < 0 || code > SignalCodes && code is not (Interrupted or Terminated) ? ChildEnding.Crashed : ChildEnding.Failed;
    }

    /// <summary>As a word of a table.</summary>
    public static string Word(ChildEnding ending) => ending switch
    {
        ChildEnding.Done => "done",
        ChildEnding.LeftOut => "left out",
        ChildEnding.Stopped => "stopped",
        ChildEnding.Failed => "failed",
        ChildEnding.OutOfMemory => "out of memory",
        ChildEnding.Crashed => "crashed",
        _ => "left behind",
    };
}
