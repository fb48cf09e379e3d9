namespace Headless.Vulkan;

/// <summary>What is bound to a pipeline's sets and bindings; filled anew or kept between commands.</summary>
/// <remarks>Sets follow the stages: compute 0; vertex 0, geometry 1, fragment 2. Constant data is copied when it is set.</remarks>
public sealed class ResourceBindings
{
    /// <summary>Sets a pipeline can have.</summary>
    public const int SetCount = 3;

    private readonly BindingSlot[][] slots = [[], [], []];
    private byte[] uniforms = new byte[256];
    private int uniformLength;

    internal ReadOnlySpan<byte> Uniforms => uniforms.AsSpan(0, uniformLength);

    /// <summary>Binds a buffer range; <paramref name="size"/> -1 reaches to the end. Offsets obey <see cref="GpuLimits.StorageBufferOffsetAlignment"/>.</summary>
    public void SetBuffer(int set, int binding, GpuBuffer buffer, long offset = 0, long size = -1)
    {
        buffer.ThrowIfDisposed();
        long length = size < 0 ? buffer.Size - offset : size;
        if (offset < 0 || length <= 0 || offset + length > buffer.Size)
        {
            throw new GpuException($"Buffer '{buffer.Name}' of {buffer.Size} bytes cannot be bound from {offset} for {length} bytes.");
        }

        Slot(set, binding).SetBuffer(buffer, offset, length);
    }

    /// <summary>Binds a texture; a Texture sees all mip levels, a RWTexture the one given.</summary>
    public void SetTexture(int set, int binding, GpuTexture texture, int mipLevel = 0)
    {
        texture.ThrowIfDisposed();
        if (mipLevel < 0 || mipLevel >= texture.Description.MipLevels)
        {
            throw new GpuException($"Texture '{texture.Name}' has {texture.Description.MipLevels} mip levels, not level {mipLevel}.");
        }

        Slot(set, binding).SetTexture(texture, mipLevel);
    }

    /// <summary>Binds a sampler.</summary>
    public void SetSampler(int set, int binding, GpuSampler sampler) => Slot(set, binding).SetSampler(sampler);

    /// <summary>Copies constant data; bytes beyond what is given read as zero in the shader.</summary>
    public void SetUniform(int set, int binding, ReadOnlySpan<byte> data)
    {
        ref BindingSlot slot = ref Slot(set, binding);
        if (slot.Kind == BindingKind.Uniform && slot.Size == data.Length)
        {
            Span<byte> old = uniforms.AsSpan((int)slot.Offset, data.Length);
            if (!data.SequenceEqual(old))
            {
                data.CopyTo(old);
                slot.UploadTicket = 0;
            }

            return;
        }

        int start = uniformLength;
        if (start + data.Length > uniforms.Length)
        {
            Array.Resize(ref uniforms, Math.Max(uniforms.Length * 2, start + data.Length));
        }

        data.CopyTo(uniforms.AsSpan(start));
        uniformLength += data.Length;
        slot.SetUniform(start, data.Length);
    }

    /// <summary>Unbinds everything.</summary>
    public void Clear()
    {
        foreach (BindingSlot[] set in slots)
        {
            Array.Clear(set);
        }

        uniformLength = 0;
    }

    internal ref BindingSlot Slot(int set, int binding)
    {
        if ((uint)set >= SetCount || binding < 0)
        {
            throw new ArgumentOutOfRangeException(nameof(set), $"Set {set}, binding {binding}: sets are 0 to {SetCount - 1}, bindings from 0.");
        }

        if (binding >= slots[set].Length)
        {
            Array.Resize(ref slots[set], Math.Max(8, (binding + 4) & ~3));
        }

        return ref slots[set][binding];
    }
}
