using System;
using System.Collections.Generic;

namespace UnityEngine.Playables;

[Serializable]
public abstract class PlayableAsset : ScriptableObject, IPlayableAsset
{
    public virtual double duration => PlayableBinding.DefaultDuration;
    public virtual IEnumerable<PlayableBinding> outputs => PlayableBinding.None;
    public abstract Playable CreatePlayable(PlayableGraph graph, GameObject owner);
}
