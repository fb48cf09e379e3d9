using System.Text.RegularExpressions;
using UnityEngine;

namespace Headless.Engine;

/// <summary>A log line that a test waits for.</summary>
sealed record ExpectedLog(LogType Type, string? Message, Regex? Pattern)
{
    public bool Matches(ReceivedLog log) =>
        log.Type == Type && (Pattern is null ? log.Message == Message : Pattern.IsMatch(log.Message));

    public override string ToString() => Pattern is null ? $"[{Type}] {Message}" : $"[{Type}] Regex: {Pattern}";
}
