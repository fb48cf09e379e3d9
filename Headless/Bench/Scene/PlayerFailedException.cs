namespace Headless.Bench.Scene;

/// <summary>A player ended before its time; the message has its last words.</summary>
internal sealed class PlayerFailedException(string message) : Exception(message);
