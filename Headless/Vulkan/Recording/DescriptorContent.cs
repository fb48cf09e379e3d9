using Headless.Shaders;
using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>
/// Turns bindings into one set's content and tells the hazards what is read and written. Content is three words a binding:
/// buffer, offset, range · view, layout, 0 · sampler, 0, 0. Constant data lies at a dynamic offset, not in the content.
/// </summary>
internal sealed class DescriptorContent(DeviceContext context)
{
    public const int Words = 3;

    private readonly long uniformAlignment = Math.Max(16, (long)context.Physical.Properties.limits.minUniformBufferOffsetAlignment);
    private ulong[] words = new ulong[32 * Words];
    private uint[] offsets = new uint[16];
    private int offsetCount;

    public ReadOnlySpan<uint> DynamicOffsets => offsets.AsSpan(0, offsetCount);

    public ReadOnlySpan<ulong> Gather(GpuPipeline pipeline, int set, ResourceBindings bindings, Submission submission, HazardTracker hazards)
    {
        StageLayout layout = pipeline.Stages[set];
        offsetCount = 0;
        int length = layout.Entries.Length * Words;
        if (length > words.Length)
        {
            words = new ulong[length];
            offsets = new uint[layout.Entries.Length];
        }

        for (int i = 0; i < layout.Entries.Length; i++)
        {
            LayoutEntry entry = layout.Entries[i];
            ref BindingSlot slot = ref bindings.Slot(set, entry.Binding);
            Span<ulong> target = words.AsSpan(i * Words, Words);
            target.Clear();
            switch (entry.Type)
            {
                case VkDescriptorType.UniformBufferDynamic:
                    Uniform(pipeline, layout, entry, ref slot, bindings, submission, hazards, target);
                    break;
                case VkDescriptorType.StorageBuffer when context.Bounds is { } bounds && entry.Resource.Name == BoundsCheck.LogName:
                    // Additions only, which need no order: the hazards do not hear of them.
                    (target[0], target[1], target[2]) = (bounds.Buffer.Handle.Handle, 0, (ulong)bounds.Buffer.Size);
                    break;
                case VkDescriptorType.StorageBuffer:
                    Storage(pipeline, layout, entry, slot, hazards, target);
                    break;
                case VkDescriptorType.Sampler:
                    target[0] = slot.Resource is GpuSampler sampler ? sampler.Handle.Handle : throw Missing(pipeline, entry, slot, "sampler");
                    break;
                default:
                    Image(pipeline, layout, entry, slot, hazards, target);
                    break;
            }
        }

        return words.AsSpan(0, length);
    }

    private static GpuException Missing(GpuPipeline pipeline, LayoutEntry entry, in BindingSlot slot, string requested)
    {
        string found = slot.Kind == BindingKind.Empty ? "nothing" : $"a {slot.Kind.ToString().ToLowerInvariant()}";
        return new GpuException($"'{pipeline.Name}': '{entry.Resource.Name}' needs a {requested}, but {found} is bound.");
    }

    private void Uniform(
        GpuPipeline pipeline, StageLayout layout, LayoutEntry entry, ref BindingSlot slot, ResourceBindings bindings, Submission submission, HazardTracker hazards,
        Span<ulong> target)
    {
        int size = entry.Resource.Size;
        if (slot.Kind == BindingKind.Buffer)
        {
            GpuBuffer buffer = (GpuBuffer)slot.Resource!;
            buffer.Require(BufferUse.Uniform, pipeline.Name, entry.Resource.Name);
            if (slot.Size < size)
            {
                throw new GpuException($"'{pipeline.Name}': constant buffer '{entry.Resource.Name}' needs {size} bytes; '{buffer.Name}' is bound with {slot.Size}.");
            }

            hazards.Read(buffer, layout.Stages);
            (target[0], target[2]) = (buffer.Handle.Handle, (ulong)size);
            offsets[offsetCount++] = (uint)slot.Offset;
            return;
        }

        if (slot.Kind is not (BindingKind.Empty or BindingKind.Uniform))
        {
            throw Missing(pipeline, entry, slot, "constant buffer");
        }

        if (slot.UploadTicket != submission.Ticket || slot.Upload.Size < size)
        {
            slot.Upload = submission.Uploads.Allocate(size, uniformAlignment);
            slot.UploadTicket = slot.Kind == BindingKind.Uniform ? submission.Ticket : 0;
            Span<byte> bytes = slot.Upload.Bytes;
            int given = slot.Kind == BindingKind.Uniform ? (int)Math.Min(slot.Size, size) : 0;
            bindings.Uniforms.Slice((int)slot.Offset, given).CopyTo(bytes);
            bytes[given..].Clear();
        }

        (target[0], target[2]) = (slot.Upload.Block.Buffer.Handle, (ulong)size);
        offsets[offsetCount++] = (uint)slot.Upload.Offset;
    }

    private static void Storage(GpuPipeline pipeline, StageLayout layout, LayoutEntry entry, in BindingSlot slot, HazardTracker hazards, Span<ulong> target)
    {
        if (slot.Kind != BindingKind.Buffer)
        {
            throw Missing(pipeline, entry, slot, "buffer");
        }

        GpuBuffer buffer = (GpuBuffer)slot.Resource!;
        buffer.Require(BufferUse.Storage, pipeline.Name, entry.Resource.Name);
        if (entry.Writes)
        {
            hazards.Write(buffer, layout.Stages);
        }
        else
        {
            hazards.Read(buffer, layout.Stages);
        }

        (target[0], target[1], target[2]) = (buffer.Handle.Handle, (ulong)slot.Offset, (ulong)slot.Size);
    }

    private static void Image(GpuPipeline pipeline, StageLayout layout, LayoutEntry entry, in BindingSlot slot, HazardTracker hazards, Span<ulong> target)
    {
        if (slot.Kind != BindingKind.Texture)
        {
            throw Missing(pipeline, entry, slot, "texture");
        }

        GpuTexture texture = (GpuTexture)slot.Resource!;
        bool storage = entry.Type == VkDescriptorType.StorageImage;
        texture.Require(storage ? TextureUse.Storage : TextureUse.Sampled, entry.ViewType, pipeline.Name, entry.Resource.Name);
        if (!entry.FitsFormat(texture))
        {
            throw new GpuException(
                $"'{pipeline.Name}': '{entry.Resource.Name}' was compiled for texels of {entry.Resource.Format}; '{texture.Name}' is {texture.Description.Format}.");
        }

        VkImageLayout imageLayout = storage ? VkImageLayout.General : VkImageLayout.ShaderReadOnlyOptimal;
        hazards.Use(texture, imageLayout, storage, layout.Stages);
        int mips = storage ? 1 : texture.Description.MipLevels;
        int layers = entry.ViewType == VkImageViewType._2d ? 1 : texture.Description.Layers;
        VkImageView view = texture.Views.Get(entry.ViewType, storage ? slot.MipLevel : 0, mips, 0, layers);
        (target[0], target[1]) = (view.Handle, (ulong)imageLayout);
    }
}
