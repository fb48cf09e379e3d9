using System.Reflection;
using System.Security.Cryptography;
using Headless.Engine;
using Headless.Player.Output;

namespace Headless.Player.Commands;

/// <summary>
/// The play after a play in one process, as the Editor's without a domain reload: statics are as the first left them, and the pictures must be the first's.
/// </summary>
internal sealed class SecondPlay
{
    private readonly List<string> first = [];

    /// <summary>What the second play did otherwise than the first; null where nothing.</summary>
    public string? Difference { get; private set; }

    /// <summary>The first play showed this.</summary>
    public void Remember(in CapturedFrame frame) => first.Add(Hash(frame));

    /// <summary>Plays again, up to the first picture that differs.</summary>
    public void Run(string scene, Assembly[] assemblies, ActivityLine activity, Interruption interruption)
    {
        activity.Begin("playing again");
        var readback = new ScreenReadback();
        PlaySession.Begin(scene, assemblies);
        for (int frame = 0; frame < first.Count && Difference is null && !interruption.Requested; frame++)
        {
            PlayerLoop.RunFrame();
            readback.Capture(frame);
            while (readback.TryTake(finish: true, out CapturedFrame captured))
                if (Hash(captured) != first[frame]) Difference = $"frame {frame + 1} of the second play differs from the first's. What did the first leave in a static?";
        }
        PlaySession.End();
        activity.End();
    }

    private static string Hash(in CapturedFrame frame) => Convert.ToHexString(SHA256.HashData(frame.Pixels));
}
