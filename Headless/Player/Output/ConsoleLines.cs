using Headless.Engine;
using Headless.Files;
using UnityEngine;

namespace Headless.Player.Output;

/// <summary>Console lines of the engine, kept apart from the live progress line. Errors go to standard error; the same line is not shown more than a few times.</summary>
internal sealed class ConsoleLines
{
    private const int Repeats = 5;
    private readonly Dictionary<string, int> seen = [];
    private bool ended;

    public ActivityLine? Activity { get; set; }
    public int Errors { get; private set; }

    /// <summary>Ends the run after this frame with exit code 1 and one line: without its shaders nothing that follows means anything, so it is not shown.</summary>
    public void EndWithoutCompiler(string line)
    {
        EngineState.QuitRequested = true;
        EngineState.ExitCode = 1;
        if (ended) return;
        ended = true;
        Errors++;
        Activity?.Break();
        Console.Error.WriteLine(Message.Of(OneLine.Message(line)));
    }

    public void Write(LogType type, string line)
    {
        if (ended) return;
        if (type is not (LogType.Log or LogType.Warning)) Errors++;
        int count = seen[line] = seen.GetValueOrDefault(line) + 1;
        if (count > Repeats && type != LogType.Log) return;
        Activity?.Break();
        (type == LogType.Log ? Console.Out : Console.Error).WriteLine(count == Repeats && type != LogType.Log ? line + " (not shown again)" : line);
    }
}
