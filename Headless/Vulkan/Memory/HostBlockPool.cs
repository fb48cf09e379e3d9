namespace Headless.Vulkan;

/// <summary>Mapped buffers that no submission uses at the moment.</summary>
internal sealed class HostBlockPool(DeviceContext context, bool readback) : IDisposable
{
    private const long BlockSize = 4 << 20;
    private const long KeptBytes = 256 << 20;

    private readonly List<HostBlock> spare = [];
    private long spareBytes;

    /// <summary>A block of at least <paramref name="size"/> bytes.</summary>
    public HostBlock Rent(long size)
    {
        int best = -1;
        for (int i = 0; i < spare.Count; i++)
        {
            if (spare[i].Size >= size && (best < 0 || spare[i].Size < spare[best].Size))
            {
                best = i;
            }
        }

        if (best < 0)
        {
            return new HostBlock(context, Math.Max(BlockSize, (size + 0xffff) & ~0xffffL), readback);
        }

        HostBlock block = spare[best];
        spare.RemoveAt(best);
        spareBytes -= block.Size;
        return block;
    }

    public void Return(HostBlock block)
    {
        if (spareBytes + block.Size > KeptBytes)
        {
            block.Dispose();
            return;
        }

        spare.Add(block);
        spareBytes += block.Size;
    }

    public void Dispose()
    {
        spare.ForEach(block => block.Dispose());
        spare.Clear();
        spareBytes = 0;
    }
}
