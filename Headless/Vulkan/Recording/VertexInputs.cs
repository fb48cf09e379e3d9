using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>The vertex and index buffers of the next draw.</summary>
internal sealed unsafe class VertexInputs
{
    private const int SlotCount = 16;

    private readonly (GpuBuffer? Buffer, long Offset)[] slots = new (GpuBuffer?, long)[SlotCount];
    private (GpuBuffer? Buffer, long Offset, bool Wide) index;
    private uint dirtySlots;
    private bool indexDirty;

    public void SetVertexBuffer(int slot, GpuBuffer? buffer, long offset)
    {
        if ((uint)slot >= SlotCount)
        {
            throw new ArgumentOutOfRangeException(nameof(slot), slot, $"Vertex buffer slots are 0 to {SlotCount - 1}.");
        }

        buffer?.CheckRange(offset, 0, "Binding a vertex buffer");
        buffer?.Require(BufferUse.Vertex, "Vertex input", $"slot {slot}");
        if (!ReferenceEquals(slots[slot].Buffer, buffer) || slots[slot].Offset != offset)
        {
            slots[slot] = (buffer, offset);
            dirtySlots |= 1u << slot;
        }
    }

    public void SetIndexBuffer(GpuBuffer buffer, long offset, bool wide)
    {
        buffer.CheckRange(offset, 0, "Binding the index buffer");
        buffer.Require(BufferUse.Index, "Index input", "indices");
        if (offset % (wide ? 4 : 2) != 0)
        {
            throw new GpuException($"Index buffer '{buffer.Name}': the offset {offset} is not a multiple of the index size.");
        }

        indexDirty |= index != (buffer, offset, wide);
        index = (buffer, offset, wide);
    }

    public void Gather(GpuRenderPipeline pipeline, bool indexed, HazardTracker hazards)
    {
        foreach (VertexStream stream in pipeline.Description.Streams)
        {
            GpuBuffer buffer = slots[stream.Slot].Buffer
                ?? throw new GpuException($"Shader '{pipeline.Name}' reads vertex buffer slot {stream.Slot}, where nothing is bound.");
            hazards.Read(buffer, VkPipelineStageFlags2.VertexInput);
        }

        if (indexed)
        {
            hazards.Read(index.Buffer ?? throw new GpuException($"Indexed draw of '{pipeline.Name}': no index buffer is bound."), VkPipelineStageFlags2.VertexInput);
        }
    }

    /// <param name="all">The command buffer is new: nothing is bound in it.</param>
    public void Bind(VkCommandBuffer commands, GpuRenderPipeline pipeline, bool indexed, bool all)
    {
        if (all)
        {
            dirtySlots = uint.MaxValue;
            indexDirty = true;
        }

        foreach (VertexStream stream in pipeline.Description.Streams)
        {
            if ((dirtySlots & (1u << stream.Slot)) != 0)
            {
                VkBuffer handle = slots[stream.Slot].Buffer!.Handle;
                ulong offset = (ulong)slots[stream.Slot].Offset;
                Vk.vkCmdBindVertexBuffers(commands, (uint)stream.Slot, 1, &handle, &offset);
                dirtySlots &= ~(1u << stream.Slot);
            }
        }

        if (indexed && indexDirty)
        {
            Vk.vkCmdBindIndexBuffer(commands, index.Buffer!.Handle, (ulong)index.Offset, index.Wide ? VkIndexType.Uint32 : VkIndexType.Uint16);
            indexDirty = false;
        }
    }
}
