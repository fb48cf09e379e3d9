namespace Headless.Vulkan;

/// <summary>A timer scope until all of its timestamps are in: two of each submission that it has a part of.</summary>
internal sealed class TimerScope(int id, string name, int depth)
{
    private ulong begin;
    private ulong ticks;
    private int awaited;

    public int Id { get; } = id;

    public int Depth { get; } = depth;

    public bool IsOpen { get; set; } = true;

    public bool IsDone => !IsOpen && awaited == 0;

    public void Await() => awaited++;

    public void Take(ulong timestamp, bool isEnd, TimestampClock clock)
    {
        awaited--;
        if (isEnd)
        {
            ticks += clock.Between(begin, timestamp);
        }
        else
        {
            begin = timestamp;
        }
    }

    public TimerResult Result(TimestampClock clock) => new(Id, name, ticks * (double)clock.NanosecondsPerTick * 1e-6, Depth);
}
