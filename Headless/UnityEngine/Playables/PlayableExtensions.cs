using System;
using Headless.Engine;

namespace UnityEngine.Playables;

public static class PlayableExtensions
{
    public static bool IsNull<U>(this U playable) where U : struct, IPlayable => playable.GetHandle().IsNull;
    public static bool IsValid<U>(this U playable) where U : struct, IPlayable => playable.GetHandle().IsValid;
    public static void Destroy<U>(this U playable) where U : struct, IPlayable => Node(playable).Graph.Remove(Node(playable));
    public static PlayableGraph GetGraph<U>(this U playable) where U : struct, IPlayable => new(Node(playable).Graph);

    public static PlayState GetPlayState<U>(this U playable) where U : struct, IPlayable => Node(playable).State;
    public static void Play<U>(this U playable) where U : struct, IPlayable => Node(playable).State = PlayState.Playing;
    public static void Pause<U>(this U playable) where U : struct, IPlayable => Node(playable).State = PlayState.Paused;

    public static double GetSpeed<U>(this U playable) where U : struct, IPlayable => Node(playable).Speed;
    public static void SetSpeed<U>(this U playable, double value) where U : struct, IPlayable => Node(playable).Speed = value;

    public static double GetTime<U>(this U playable) where U : struct, IPlayable => Node(playable).Time;
    public static double GetPreviousTime<U>(this U playable) where U : struct, IPlayable => Node(playable).PreviousTime;
    public static void SetTime<U>(this U playable, double value) where U : struct, IPlayable => Node(playable).SetTime(value);

    public static double GetDuration<U>(this U playable) where U : struct, IPlayable => Node(playable).Duration;
    public static void SetDuration<U>(this U playable, double value) where U : struct, IPlayable => Node(playable).Duration = value;

    public static int GetInputCount<U>(this U playable) where U : struct, IPlayable => Node(playable).InputCount;
    public static void SetInputCount<U>(this U playable, int value) where U : struct, IPlayable => Node(playable).InputCount = value;

    public static Playable GetInput<U>(this U playable, int inputPort) where U : struct, IPlayable => new(new PlayableHandle(WithPort(playable, inputPort).Input(inputPort)));
    public static float GetInputWeight<U>(this U playable, int inputIndex) where U : struct, IPlayable => WithPort(playable, inputIndex).Weight(inputIndex);
    public static void SetInputWeight<U>(this U playable, int inputIndex, float weight) where U : struct, IPlayable => WithPort(playable, inputIndex).SetWeight(inputIndex, weight);

    public static void ConnectInput<U, V>(this U playable, int inputIndex, V sourcePlayable, int sourceOutputIndex)
        where U : struct, IPlayable where V : struct, IPlayable => playable.ConnectInput(inputIndex, sourcePlayable, sourceOutputIndex, 0f);

    public static void ConnectInput<U, V>(this U playable, int inputIndex, V sourcePlayable, int sourceOutputIndex, float weight)
        where U : struct, IPlayable where V : struct, IPlayable
    {
        playable.GetGraph().Connect(sourcePlayable, sourceOutputIndex, playable, inputIndex);
        playable.SetInputWeight(inputIndex, weight);
    }

    public static void DisconnectInput<U>(this U playable, int inputPort) where U : struct, IPlayable => WithPort(playable, inputPort).Connect(inputPort, null);

    public static int AddInput<U, V>(this U playable, V sourcePlayable, int sourceOutputIndex, float weight = 0f) where U : struct, IPlayable where V : struct, IPlayable
    {
        int index = playable.GetInputCount();
        playable.SetInputCount(index + 1);
        playable.ConnectInput(index, sourcePlayable, sourceOutputIndex, weight);
        return index;
    }

    static PlayableNode Node<U>(U playable) where U : struct, IPlayable => playable.GetHandle().Node;

    static PlayableNode WithPort<U>(U playable, int port) where U : struct, IPlayable
    {
        PlayableNode node = Node(playable);
        return (uint)port < (uint)node.InputCount ? node : throw new IndexOutOfRangeException($"The playable has {node.InputCount} inputs and none {port}.");
    }
}
