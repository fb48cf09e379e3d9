namespace Headless.Vulkan;

/// <summary>One binding; Offset and Size are a buffer's range or the place of constant data in the owner's bytes.</summary>
internal struct BindingSlot
{
    public BindingKind Kind;
    public object? Resource;
    public long Offset;
    public long Size;
    public int MipLevel;

    /// <summary>Submission that already holds this constant data, and where: repeated commands upload it once.</summary>
    public ulong UploadTicket;
    public HostSlice Upload;

    public void SetBuffer(GpuBuffer buffer, long offset, long size) => Set(BindingKind.Buffer, buffer, offset, size, 0);

    public void SetTexture(GpuTexture texture, int mipLevel) => Set(BindingKind.Texture, texture, 0, 0, mipLevel);

    public void SetSampler(GpuSampler sampler) => Set(BindingKind.Sampler, sampler, 0, 0, 0);

    public void SetUniform(long start, long length) => Set(BindingKind.Uniform, null, start, length, 0);

    private void Set(BindingKind kind, object? resource, long offset, long size, int mipLevel)
    {
        Kind = kind;
        Resource = resource;
        Offset = offset;
        Size = size;
        MipLevel = mipLevel;
        UploadTicket = 0;
    }
}
