using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>
/// Nested timer scopes. A scope has the time of its commands alone: where it spans submissions, the time between them, in which the
/// device may wait for the next, is no part of it.
/// </summary>
internal sealed unsafe class TimerCommands
{
    private readonly CommandStream stream;
    private readonly List<TimerScope> open = [];
    private readonly Queue<TimerScope> pending = new();
    private bool paused;
    private int lastId;

    public TimerCommands(CommandStream stream)
    {
        this.stream = stream;
        stream.PauseTimers = Pause;
        stream.ResumeTimers = Resume;
    }

    public int Begin(string name)
    {
        SubmitWhenFull();
        Resume();
        TimerScope scope = new(++lastId, name, open.Count);
        open.Add(scope);
        pending.Enqueue(scope);
        Mark(scope, isEnd: false);
        return scope.Id;
    }

    public void End(int id)
    {
        if (open.Count == 0 || open[^1].Id != id)
        {
            string innermost = open.Count == 0 ? "none is open" : $"the innermost open one is {open[^1].Id}";
            throw new InvalidOperationException($"Timer {id} cannot end here: {innermost}. Timers close in reverse order.");
        }

        SubmitWhenFull();
        TimerScope scope = open[^1];
        open.RemoveAt(open.Count - 1);
        scope.IsOpen = false;
        if (!paused)
        {
            Mark(scope, isEnd: true);
        }
    }

    /// <summary>Finished scopes in the order they began; an unfinished one holds back those after it.</summary>
    public IReadOnlyList<TimerResult> Collect()
    {
        List<TimerResult> results = [];
        while (pending.TryPeek(out TimerScope? scope) && scope.IsDone)
        {
            results.Add(pending.Dequeue().Result(stream.Context.Timestamps));
        }

        return results;
    }

    /// <summary>The last commands of a submission.</summary>
    private void Pause()
    {
        if (!paused)
        {
            open.ForEach(scope => Mark(scope, isEnd: true));
        }

        paused = true;
    }

    /// <summary>Before the first command of the next.</summary>
    private void Resume()
    {
        if (paused)
        {
            open.ForEach(scope => Mark(scope, isEnd: false));
        }

        paused = false;
    }

    private void SubmitWhenFull()
    {
        if (stream.Current.Timestamps.IsFull)
        {
            stream.Submit();
        }
    }

    private void Mark(TimerScope scope, bool isEnd)
    {
        if (!stream.Context.Limits.Timestamps)
        {
            return;
        }

        Submission submission = stream.Current;
        bool between = stream.Context.OnProcessor && submission.Timestamps.IsDue(submission.CommandCount);
        if (between)
        {
            Finish();
        }

        submission.Timestamps.Write(submission.Commands, submission.CommandCount, scope, isEnd);
        if (between)
        {
            Finish();
        }
    }

    /// <summary>
    /// A rasterizer on the CPU keeps draws and timestamps back and lets dispatches pass them. A barrier makes it carry them out: one
    /// before a timestamp ends the draws that belong before it, one after it ends the timestamp. A GPU needs neither.
    /// </summary>
    private void Finish()
    {
        stream.LeaveRendering();
        VkMemoryBarrier2 memory = new()
        {
            srcStageMask = VkPipelineStageFlags2.AllCommands,
            srcAccessMask = VkAccessFlags2.MemoryWrite,
            dstStageMask = VkPipelineStageFlags2.AllCommands,
            dstAccessMask = VkAccessFlags2.MemoryRead | VkAccessFlags2.MemoryWrite,
        };
        VkDependencyInfo info = new() { memoryBarrierCount = 1, pMemoryBarriers = &memory };
        Vk.vkCmdPipelineBarrier2(stream.Commands, &info);
    }
}
