using System;
using System.Collections.Generic;
using System.Globalization;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Headless.Engine;

/// <summary>Console lines `[Error] message (object name)`, and Application.logMessageReceived.</summary>
sealed class ConsoleLogHandler : ILogHandler
{
    public void LogFormat(LogType logType, Object? context, string format, params object?[] args)
    {
        string message = args is { Length: > 0 } ? string.Format(CultureInfo.InvariantCulture, format, args) : format;
        string stack = logType is LogType.Error or LogType.Assert ? CallerStack() : "";
        Write(logType, message, stack, context, "");
    }

    public void LogException(Exception exception, Object? context)
    {
        if (exception is null) throw new ArgumentNullException(nameof(exception));
        string message = $"{exception.GetType().Name}: {exception.Message}";
        string stack = exception.StackTrace ?? "";
        for (Exception? inner = exception.InnerException; inner is not null; inner = inner.InnerException)
            stack = $"{stack}\nRethrow of {inner.GetType().Name}: {inner.Message}\n{inner.StackTrace}";
        Write(LogType.Exception, message, stack, context, "\n" + stack);
    }

    // The caller's frames, without those of the engine around them.
    static string CallerStack()
    {
        var lines = new List<string>();
        foreach (string line in Environment.StackTrace.Split('\n'))
        {
            string frame = line.Trim();
            if (frame.StartsWith("at Headless.Engine.", StringComparison.Ordinal) || frame.StartsWith("at System.", StringComparison.Ordinal)
                || frame.StartsWith("at UnityEngine.Debug.", StringComparison.Ordinal) || frame.StartsWith("at UnityEngine.Logger.", StringComparison.Ordinal)) continue;
            lines.Add(frame);
        }
        return string.Join('\n', lines);
    }

    static void Write(LogType type, string message, string stack, Object? context, string suffix)
    {
        string owner = context is not null && context.IsAlive ? $" ({context.NameCore})" : "";
        string line = $"[{type}] {message}{owner}{suffix.TrimEnd()}";
        if (EngineHooks.Console is { } console) console(type, line);
        else (type is LogType.Log ? System.Console.Out : System.Console.Error).WriteLine(line);
        Application.SendLog(message, stack, type);
    }
}
