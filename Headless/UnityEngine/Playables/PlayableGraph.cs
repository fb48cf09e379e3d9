using System;
using Headless.Engine;

namespace UnityEngine.Playables;

public struct PlayableGraph
{
    readonly PlayableGraphState? m_State;

    internal PlayableGraph(PlayableGraphState state) => m_State = state;

    internal readonly PlayableGraphState State => IsValid() ? m_State! : throw new InvalidOperationException("The PlayableGraph is invalid. It was not created, or has been destroyed.");

    public static PlayableGraph Create() => Create("");
    public static PlayableGraph Create(string name) => new(new PlayableGraphState(name));

    public readonly bool IsValid() => m_State is { IsValid: true };
    public readonly bool IsPlaying() => State.IsPlaying;
    public readonly string GetEditorName() => State.Name;
    public readonly void Play() => State.Play();
    public readonly void Stop() => State.Stop();
    public readonly void Destroy() => State.Destroy();
    public readonly void Evaluate() => Evaluate(0f);
    public readonly void Evaluate(float deltaTime) => State.Evaluate(deltaTime, FrameData.EvaluationType.Evaluate);

    public readonly DirectorUpdateMode GetTimeUpdateMode() => State.UpdateMode;
    public readonly void SetTimeUpdateMode(DirectorUpdateMode value) => State.UpdateMode = value;
    public readonly IExposedPropertyTable GetResolver() => State.Resolver!;
    public readonly void SetResolver(IExposedPropertyTable value) => State.Resolver = value;

    public readonly int GetPlayableCount() => State.PlayableCount;
    public readonly int GetOutputCount() => State.OutputCount;

    public readonly bool Connect<U, V>(U source, int sourceOutputPort, V destination, int destinationInputPort) where U : struct, IPlayable where V : struct, IPlayable
    {
        PlayableNode from = source.GetHandle().Node, to = destination.GetHandle().Node;
        string? wrong = from.Graph != State || to.Graph != State ? "both playables must belong to the graph"
            : sourceOutputPort != 0 ? "a playable has one output here"
            : (uint)destinationInputPort >= (uint)to.InputCount ? $"there is no input {destinationInputPort}"
            : to.Input(destinationInputPort) is not null ? $"the input {destinationInputPort} is connected already" : null;
        if (wrong is null) to.Connect(destinationInputPort, from);
        else Debug.LogError($"Cannot connect the playables: {wrong}.");
        return wrong is null;
    }

    public readonly void Disconnect<U>(U input, int inputPort) where U : struct, IPlayable => input.DisconnectInput(inputPort);
    public readonly void DestroyPlayable<U>(U playable) where U : struct, IPlayable => State.Remove(playable.GetHandle().Node);
}
