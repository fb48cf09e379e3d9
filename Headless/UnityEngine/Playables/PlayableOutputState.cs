using Object = UnityEngine.Object;

namespace Headless.Engine;

/// <summary>An output of a graph: where a walk through it begins.</summary>
sealed class PlayableOutputState
{
    public PlayableOutputState(PlayableGraphState graph, string name)
    {
        Graph = graph;
        Name = name;
    }

    public PlayableGraphState Graph { get; }
    public string Name { get; }
    public PlayableNode? Source { get; set; }
    public float Weight { get; set; } = 1f;
    public Object? UserData { get; set; }
}
