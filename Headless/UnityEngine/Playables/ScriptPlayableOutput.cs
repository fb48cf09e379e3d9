namespace UnityEngine.Playables;

public struct ScriptPlayableOutput : IPlayableOutput
{
    readonly PlayableOutputHandle m_Handle;

    ScriptPlayableOutput(PlayableOutputHandle handle) => m_Handle = handle;

    public static ScriptPlayableOutput Null => default;

    public static ScriptPlayableOutput Create(PlayableGraph graph, string name) => new(new PlayableOutputHandle(graph.State.AddOutput(name)));

    public readonly PlayableOutputHandle GetHandle() => m_Handle;

    public static implicit operator PlayableOutput(ScriptPlayableOutput output) => new(output.m_Handle);
    public static explicit operator ScriptPlayableOutput(PlayableOutput output) => new(output.GetHandle());
}
