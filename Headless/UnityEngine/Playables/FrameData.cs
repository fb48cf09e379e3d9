using Headless.Engine;

namespace UnityEngine.Playables;

public struct FrameData
{
    readonly PlayableVisit m_Visit;

    internal FrameData(PlayableVisit visit) => m_Visit = visit;

    public ulong frameId => m_Visit.FrameId;
    public float deltaTime => m_Visit.DeltaTime;
    public float weight => m_Visit.Weight;
    public float effectiveWeight => m_Visit.EffectiveWeight;
    public float effectiveParentSpeed => m_Visit.ParentSpeed;
    public float effectiveSpeed => m_Visit.Speed;
    public EvaluationType evaluationType => m_Visit.Evaluation;
    public bool seekOccurred => m_Visit.HasSeeked;
    public PlayState effectivePlayState => m_Visit.State;
    public PlayableOutput output => new(m_Visit.Output);

    public enum EvaluationType
    {
        Evaluate,
        Playback,
    }
}
