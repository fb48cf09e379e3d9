using System;
using Headless.Engine;

namespace UnityEngine.Playables;

public struct PlayableOutputHandle : IEquatable<PlayableOutputHandle>
{
    readonly PlayableOutputState? m_Output;

    internal PlayableOutputHandle(PlayableOutputState? output) => m_Output = output;

    public static PlayableOutputHandle Null => default;

    internal readonly bool IsNull => m_Output is null;
    internal readonly bool IsValid => m_Output is { Graph.IsValid: true };

    internal readonly PlayableOutputState Output
    {
        get
        {
            if (m_Output is null) throw new NullReferenceException("The PlayableOutput is null.");
            return IsValid ? m_Output : throw new InvalidOperationException("The PlayableOutput is invalid. Its graph has been destroyed.");
        }
    }

    public readonly bool Equals(PlayableOutputHandle other) => m_Output == other.m_Output;
    public override readonly bool Equals(object? p) => p is PlayableOutputHandle other && Equals(other);
    public override readonly int GetHashCode() => m_Output?.GetHashCode() ?? 0;
    public static bool operator ==(PlayableOutputHandle lhs, PlayableOutputHandle rhs) => lhs.Equals(rhs);
    public static bool operator !=(PlayableOutputHandle lhs, PlayableOutputHandle rhs) => !lhs.Equals(rhs);
}
