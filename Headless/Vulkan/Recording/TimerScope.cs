namespace Headless.Vulkan;

/// <summary>A timer scope until both of its timestamps are in.</summary>
internal sealed class TimerScope(int id, string name, int depth)
{
    private ulong? begin;
    private ulong? end;

    public int Id { get; } = id;

    public int Depth { get; } = depth;

    /// <summary>No timestamp will come: the device has none.</summary>
    public bool Skipped { get; set; }

    public bool IsDone => Skipped || (begin is not null && end is not null);

    public void Take(ulong ticks, bool isEnd)
    {
        if (isEnd)
        {
            end = ticks;
        }
        else
        {
            begin = ticks;
        }
    }

    public TimerResult Result(float nanosecondsPerTick) =>
        new(Id, name, begin <= end ? (double)(end - begin)! * nanosecondsPerTick * 1e-6 : 0, Depth);
}
