using System.Reflection;

namespace Headless.Pacing;

/// <summary>
/// Times of the GPU scopes of each frame, as the player's timings.csv has them, and how often each came. The event is internal to the
/// stand-in: taken by reflection, so that players of several builds are understood.
/// </summary>
internal sealed class FinishedScopes : IDisposable
{
    // The player's scope around a frame comes before those inside it.
    private const string Frame = "Frame";

    private readonly Dictionary<string, (double Milliseconds, int Times)> sums = [];
    private readonly Action<int, double, int, string> report;
    private readonly EventInfo finished;
    private readonly Delegate handler;
    private int frame = -1;

    public FinishedScopes(Action<int, double, int, string> report)
    {
        this.report = report;
        finished = typeof(UnityEngine.GraphicsBuffer).Assembly.GetTypes().First(t => t.Name == "GpuTimings")
            .GetEvent("Finished", BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic)!;
        handler = (Action<string, double>)Add;
        finished.GetAddMethod(nonPublic: true)!.Invoke(null, [handler]);
    }

    public void Dispose() => finished.GetRemoveMethod(nonPublic: true)!.Invoke(null, [handler]);

    private void Add(string name, double milliseconds)
    {
        if (name == Frame)
        {
            foreach (var (scope, sum) in sums) report(frame, sum.Milliseconds, sum.Times, scope);
            sums.Clear();
            frame++;
        }
        else if (frame >= 0)
        {
            (double all, int times) = sums.GetValueOrDefault(name);
            sums[name] = (all + milliseconds, times + 1);
        }
    }
}
