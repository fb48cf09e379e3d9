using UnityEngine.Playables;

namespace Headless.Engine;

/// <summary>What a walk through a graph knows where it comes to a playable; speeds, weights and states are those of all playables above it as well.</summary>
readonly record struct PlayableVisit
{
    public ulong FrameId { get; init; }
    public float DeltaTime { get; init; }
    public FrameData.EvaluationType Evaluation { get; init; }
    public PlayableOutputHandle Output { get; init; }
    public float Weight { get; init; }
    public float EffectiveWeight { get; init; }
    public float ParentSpeed { get; init; }
    public float Speed { get; init; }
    public PlayState State { get; init; }
    public bool HasSeeked { get; init; }

    /// <summary>One playable further down.</summary>
    public PlayableVisit At(PlayableNode node, float weight) => this with
    {
        Weight = weight,
        EffectiveWeight = EffectiveWeight * weight,
        ParentSpeed = Speed,
        Speed = Speed * (float)node.Speed,
        State = State == PlayState.Playing ? node.State : PlayState.Paused,
        HasSeeked = node.IsTimeSet,
    };
}
