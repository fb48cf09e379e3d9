using Headless.Engine;
using Headless.Vulkan;

namespace Headless.Player.Output;

/// <summary>Puts one GPU scope around each frame and hands out its time and that of the scopes inside, when the device has finished them.</summary>
internal sealed class FrameTimer : IDisposable
{
    private const string Scope = "Frame";

    private readonly Action<int, double, IReadOnlyList<(string Pass, double Milliseconds)>> finished;
    private readonly Action? innerEnd = EngineHooks.EndFrame;
    private readonly Action? innerBegin = EngineHooks.BeginFrame;
    private readonly List<(string, double)> passes = [];
    private int open, next;
    private (int Frame, double Milliseconds)? current;

    /// <param name="finished">Frame number from 0, its GPU milliseconds, those of its passes.</param>
    public FrameTimer(Action<int, double, IReadOnlyList<(string Pass, double Milliseconds)>> finished)
    {
        this.finished = finished;
        EngineHooks.BeginFrame = Begin;
        EngineHooks.EndFrame = End;
        GpuTimings.Finished += Add;
    }

    /// <summary>Waits for the device and hands out what is left.</summary>
    public void Finish()
    {
        GraphicsDevice.Device.WaitIdle();
        GpuTimings.Collect();
        Deliver();
    }

    public void Dispose()
    {
        EngineHooks.BeginFrame = innerBegin;
        EngineHooks.EndFrame = innerEnd;
        GpuTimings.Finished -= Add;
    }

    private void Begin()
    {
        open = GraphicsDevice.Recorder.BeginTimer(Scope);
        innerBegin?.Invoke();
    }

    private void End()
    {
        GraphicsDevice.Recorder.EndTimer(open);
        innerEnd?.Invoke();
    }

    /// <summary>Scopes come in the order they began: a frame's own first, then those inside it.</summary>
    private void Add(string name, double milliseconds)
    {
        if (name == Scope)
        {
            Deliver();
            current = (next++, milliseconds);
        }
        else if (current is not null)
        {
            passes.Add((name, milliseconds));
        }
    }

    private void Deliver()
    {
        if (current is { } frame) finished(frame.Frame, frame.Milliseconds, passes);
        current = null;
        passes.Clear();
    }
}
