using System;

namespace UnityEngine.Playables;

public struct ScriptPlayable<T> : IPlayable, IEquatable<ScriptPlayable<T>> where T : class, IPlayableBehaviour, new()
{
    readonly PlayableHandle m_Handle;

    ScriptPlayable(PlayableHandle handle)
    {
        if (handle.IsValid && !typeof(T).IsAssignableFrom(handle.Node.Type))
            throw new InvalidCastException($"A playable of type {handle.Node.Type} is not one of the behaviour {typeof(T)}.");
        m_Handle = handle;
    }

    public static ScriptPlayable<T> Null => default;

    public static ScriptPlayable<T> Create(PlayableGraph graph, int inputCount = 0) => Add(graph, new T(), inputCount);

    /// <summary>The behaviour is a copy of the template.</summary>
    public static ScriptPlayable<T> Create(PlayableGraph graph, T template, int inputCount = 0) => Add(graph, template switch
    {
        null => new T(),
        ICloneable original => (T)original.Clone(),
        _ => throw new ArgumentException($"{template.GetType()} cannot be copied: it is no ICloneable."),
    }, inputCount);

    public readonly PlayableHandle GetHandle() => m_Handle;
    public readonly T GetBehaviour() => m_Handle.IsValid ? (T)m_Handle.Node.Behaviour! : null!;
    public readonly bool Equals(ScriptPlayable<T> other) => m_Handle == other.m_Handle;

    public static implicit operator Playable(ScriptPlayable<T> playable) => new(playable.m_Handle);
    public static explicit operator ScriptPlayable<T>(Playable playable) => new(playable.GetHandle());

    static ScriptPlayable<T> Add(PlayableGraph graph, T behaviour, int inputCount) => new(new PlayableHandle(graph.State.Add(typeof(T), behaviour, inputCount)));
}
