using System;
using Headless.Engine;

namespace UnityEngine.Playables;

public struct PlayableHandle : IEquatable<PlayableHandle>
{
    readonly PlayableNode? m_Node;

    internal PlayableHandle(PlayableNode? node) => m_Node = node;

    public static PlayableHandle Null => default;

    internal readonly bool IsNull => m_Node is null;
    internal readonly bool IsValid => m_Node is { IsAlive: true };

    internal readonly PlayableNode Node
    {
        get
        {
            if (m_Node is null) throw new NullReferenceException("The Playable is null.");
            return m_Node.IsAlive ? m_Node : throw new InvalidOperationException("The Playable is invalid. It has been destroyed.");
        }
    }

    public readonly bool Equals(PlayableHandle other) => m_Node == other.m_Node;
    public override readonly bool Equals(object? p) => p is PlayableHandle other && Equals(other);
    public override readonly int GetHashCode() => m_Node?.GetHashCode() ?? 0;
    public static bool operator ==(PlayableHandle x, PlayableHandle y) => x.Equals(y);
    public static bool operator !=(PlayableHandle x, PlayableHandle y) => !x.Equals(y);
}
