using System;

namespace UnityEngine.Playables;

public struct Playable : IPlayable, IEquatable<Playable>
{
    readonly PlayableHandle m_Handle;

    internal Playable(PlayableHandle handle) => m_Handle = handle;

    public static Playable Null => default;

    public static Playable Create(PlayableGraph graph, int inputCount = 0) => new(new PlayableHandle(graph.State.Add(typeof(Playable), null, inputCount)));

    public readonly PlayableHandle GetHandle() => m_Handle;
    public readonly Type GetPlayableType() => m_Handle.Node.Type;
    public readonly bool IsPlayableOfType<T>() where T : struct, IPlayable => GetPlayableType() == typeof(T);
    public readonly bool Equals(Playable other) => m_Handle == other.m_Handle;
}
