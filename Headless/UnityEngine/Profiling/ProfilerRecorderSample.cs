namespace Unity.Profiling;

public struct ProfilerRecorderSample
{
    internal ProfilerRecorderSample(long value, long count)
    {
        Value = value;
        Count = count;
    }

    public long Value { get; }
    public long Count { get; }
}
