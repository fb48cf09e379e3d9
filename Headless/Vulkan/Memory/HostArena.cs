namespace Headless.Vulkan;

/// <summary>Hands out mapped memory front to back; all of it comes back when the submission has run.</summary>
internal sealed class HostArena(HostBlockPool pool) : IDisposable
{
    private const long LargeSize = 1 << 20;

    private readonly List<HostBlock> used = [];
    private HostBlock? current;
    private long position;

    /// <summary>Bytes handed out since the last reset.</summary>
    public long Used { get; private set; }

    /// <param name="size">Bytes.</param>
    /// <param name="alignment">A power of two.</param>
    public HostSlice Allocate(long size, long alignment)
    {
        Used += size;
        if (size > LargeSize)
        {
            HostBlock own = pool.Rent(size);
            used.Add(own);
            return new HostSlice(own, 0, size);
        }

        long start = (position + alignment - 1) & ~(alignment - 1);
        if (current is null || start + size > current.Size)
        {
            current = pool.Rent(size);
            used.Add(current);
            start = 0;
        }

        position = start + size;
        return new HostSlice(current, start, size);
    }

    public void Reset()
    {
        used.ForEach(pool.Return);
        used.Clear();
        current = null;
        position = 0;
        Used = 0;
    }

    public void Dispose()
    {
        used.ForEach(block => block.Dispose());
        used.Clear();
    }
}
