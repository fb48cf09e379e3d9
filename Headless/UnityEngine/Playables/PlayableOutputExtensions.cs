using System;

namespace UnityEngine.Playables;

public static class PlayableOutputExtensions
{
    public static bool IsOutputNull<U>(this U output) where U : struct, IPlayableOutput => output.GetHandle().IsNull;
    public static bool IsOutputValid<U>(this U output) where U : struct, IPlayableOutput => output.GetHandle().IsValid;

    public static Playable GetSourcePlayable<U>(this U output) where U : struct, IPlayableOutput => new(new PlayableHandle(output.GetHandle().Output.Source));

    public static void SetSourcePlayable<U, V>(this U output, V value) where U : struct, IPlayableOutput where V : struct, IPlayable
    {
        PlayableHandle source = value.GetHandle();
        if (source.IsValid && source.Node.Graph != output.GetHandle().Output.Graph) throw new ArgumentException("The playable belongs to another graph than the output.");
        output.GetHandle().Output.Source = source.IsNull ? null : source.Node;
    }

    public static Object GetUserData<U>(this U output) where U : struct, IPlayableOutput => output.GetHandle().Output.UserData!;
    public static void SetUserData<U>(this U output, Object value) where U : struct, IPlayableOutput => output.GetHandle().Output.UserData = value;

    public static float GetWeight<U>(this U output) where U : struct, IPlayableOutput => output.GetHandle().Output.Weight;
    public static void SetWeight<U>(this U output, float value) where U : struct, IPlayableOutput => output.GetHandle().Output.Weight = value;
}
