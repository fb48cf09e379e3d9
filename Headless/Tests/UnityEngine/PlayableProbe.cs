using System;
using UnityEngine.Playables;

namespace Headless.Tests.UnityEngineApi;

/// <summary>Writes down what a graph tells it.</summary>
public sealed class PlayableProbe : PlayableBehaviour
{
    public string name = "";
    public Action<Playable>? onPrepare;

    public override void OnGraphStart(Playable playable) => Add("start");
    public override void OnGraphStop(Playable playable) => Add("stop");
    public override void OnPlayableCreate(Playable playable) => Add("create");
    public override void OnPlayableDestroy(Playable playable) => Add("destroy");
    public override void OnBehaviourPlay(Playable playable, FrameData info) => Add("play");
    public override void OnBehaviourPause(Playable playable, FrameData info) => Add("pause:" + info.effectivePlayState);
    public override void ProcessFrame(Playable playable, FrameData info, object playerData) => Add("process");

    public override void PrepareFrame(Playable playable, FrameData info)
    {
        Add("prepare");
        onPrepare?.Invoke(playable);
    }

    void Add(string call) => EngineFixture.Calls.Add(name + "." + call);
}
