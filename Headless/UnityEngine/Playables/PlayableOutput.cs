using System;

namespace UnityEngine.Playables;

public struct PlayableOutput : IPlayableOutput, IEquatable<PlayableOutput>
{
    readonly PlayableOutputHandle m_Handle;

    internal PlayableOutput(PlayableOutputHandle handle) => m_Handle = handle;

    public static PlayableOutput Null => default;

    public readonly PlayableOutputHandle GetHandle() => m_Handle;
    public readonly bool Equals(PlayableOutput other) => m_Handle == other.m_Handle;
}
