using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Playables;

namespace Headless.Engine;

/// <summary>The graphs that play: those that follow the game's time are evaluated between Update and LateUpdate.</summary>
static class PlayableGraphs
{
    static readonly List<PlayableGraphState> s_Playing = new();

    public static void Add(PlayableGraphState graph) => s_Playing.Add(graph);
    public static void Remove(PlayableGraphState graph) => s_Playing.Remove(graph);
    public static void Clear() => s_Playing.Clear();

    public static void Update()
    {
        if (s_Playing.Count == 0) return;
        foreach (PlayableGraphState graph in s_Playing.ToArray())
        {
            if (!graph.IsPlaying) continue;
            if (graph.UpdateMode == DirectorUpdateMode.GameTime) graph.Evaluate(Time.deltaTime, FrameData.EvaluationType.Playback);
            else if (graph.UpdateMode == DirectorUpdateMode.UnscaledGameTime) graph.Evaluate(Time.unscaledDeltaTime, FrameData.EvaluationType.Playback);
        }
    }
}
