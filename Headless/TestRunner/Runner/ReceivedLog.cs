using UnityEngine;

namespace Headless.Engine;

/// <summary>A line that was logged during a test.</summary>
sealed class ReceivedLog(LogType type, string message, string stackTrace)
{
    public LogType Type { get; } = type;
    public string Message { get; } = message;
    public string StackTrace { get; } = stackTrace;
    public bool IsHandled { get; set; }
    public bool IsFailing { get; init; }

    public override string ToString() => $"[{Type}] {Message}";
}
