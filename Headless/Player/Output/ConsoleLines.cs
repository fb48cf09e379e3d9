using UnityEngine;

namespace Headless.Player.Output;

/// <summary>Console lines of the engine, kept apart from the live progress line. Errors go to standard error; the same line is not shown more than a few times.</summary>
internal sealed class ConsoleLines
{
    private const int Repeats = 5;
    private readonly Dictionary<string, int> seen = [];

    public ActivityLine? Activity { get; set; }
    public int Errors { get; private set; }

    public void Write(LogType type, string line)
    {
        if (type is not (LogType.Log or LogType.Warning)) Errors++;
        int count = seen[line] = seen.GetValueOrDefault(line) + 1;
        if (count > Repeats && type != LogType.Log) return;
        Activity?.Break();
        (type == LogType.Log ? Console.Out : Console.Error).WriteLine(count == Repeats && type != LogType.Log ? line + " (not shown again)" : line);
    }
}
