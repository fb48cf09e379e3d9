namespace Headless.Vulkan;

/// <summary>A piece of a mapped buffer.</summary>
internal readonly unsafe struct HostSlice(HostBlock block, long offset, long size)
{
    public HostBlock Block { get; } = block;

    public long Offset { get; } = offset;

    public long Size { get; } = size;

    public Span<byte> Bytes => new(Block.Pointer + Offset, checked((int)Size));
}
