using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>The timestamps of one submission and who waits for them.</summary>
internal sealed unsafe class TimestampLog : IDisposable
{
    public const int Capacity = 4096;

    private readonly DeviceContext context;
    private readonly VkQueryPool pool;
    private readonly List<(TimerScope Scope, bool IsEnd, int Query)> waiting = [];
    private readonly ulong[] ticks = new ulong[Capacity];
    private int count;
    private int commandsAtLast = -1;

    public TimestampLog(DeviceContext context)
    {
        this.context = context;
        if (!context.Limits.Timestamps)
        {
            return;
        }

        VkQueryPoolCreateInfo info = new() { queryType = VkQueryType.Timestamp, queryCount = Capacity };
        VkQueryPool created;
        Vk.vkCreateQueryPool(context.Handle, &info, null, &created).Check("Creating the timestamp pool");
        pool = created;
    }

    public int Count => count;

    /// <summary>What is left is for the end of the submission, where all open scopes share one.</summary>
    public bool IsFull => count == Capacity - 1;

    /// <summary>Whether a timestamp now would say anything that the last one does not.</summary>
    public bool IsDue(int commandCount) => commandCount != commandsAtLast || count == 0;

    public void Reset(VkCommandBuffer commands)
    {
        count = 0;
        commandsAtLast = -1;
        if (!pool.IsNull)
        {
            Vk.vkCmdResetQueryPool(commands, pool, 0, Capacity);
        }
    }

    /// <summary>Takes the time after all commands so far; neighbours with no command between share one timestamp.</summary>
    public void Write(VkCommandBuffer commands, int commandCount, TimerScope scope, bool isEnd)
    {
        if (IsDue(commandCount))
        {
            Vk.vkCmdWriteTimestamp(commands, VkPipelineStageFlags.BottomOfPipe, pool, (uint)count++);
            commandsAtLast = commandCount;
        }

        scope.Await();
        waiting.Add((scope, isEnd, count - 1));
    }

    public void Read()
    {
        if (count == 0)
        {
            return;
        }

        fixed (ulong* first = ticks)
        {
            Vk.vkGetQueryPoolResults(
                context.Handle, pool, 0, (uint)count, (nuint)count * sizeof(ulong), first, sizeof(ulong),
                VkQueryResultFlags._64 | VkQueryResultFlags.Wait).Check("Reading timestamps");
        }

        foreach ((TimerScope scope, bool isEnd, int query) in waiting)
        {
            scope.Take(ticks[query], isEnd, context.Timestamps);
        }

        waiting.Clear();
    }

    public void Dispose()
    {
        if (!pool.IsNull)
        {
            Vk.vkDestroyQueryPool(context.Handle, pool, null);
        }
    }
}
