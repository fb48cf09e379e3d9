namespace Headless.Pacing;

/// <summary>A number that only grows; what counts is by how much since the last frame.</summary>
internal sealed class FrameCounter(string name, Func<long> read)
{
    private long before;

    public string Name => name;

    public long Advance()
    {
        long now = read();
        long grown = now - before;
        before = now;
        return grown;
    }
}
