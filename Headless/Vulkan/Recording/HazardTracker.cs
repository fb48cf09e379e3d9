using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>Puts a barrier before a command when, and only when, it collides with a command since the last barrier.</summary>
/// <remarks>
/// Commands are numbered; a resource knows the numbers of its last read and write. A barrier orders all commands before it
/// against all after it, so a collision exists only with numbers above the last barrier's:
/// write 1 to A, write 2 to B, read 3 of A (barrier before 3), read 4 of B (none: the same barrier covers it).
/// Between dispatches that share buffers the barrier names storage accesses of the compute stage alone, which lets a driver keep its other
/// caches. It orders nothing against drawings and copies: what these access is held against the last barrier for all stages.
/// </remarks>
internal sealed unsafe class HazardTracker
{
    private const VkAccessFlags2 AllAccess = VkAccessFlags2.MemoryRead | VkAccessFlags2.MemoryWrite;

    private const VkPipelineStageFlags2 Compute = VkPipelineStageFlags2.ComputeShader, Indirect = VkPipelineStageFlags2.DrawIndirect;

    private readonly List<(GpuResource Resource, bool Write)> accesses = new(32);
    private readonly List<(GpuTexture Texture, VkImageLayout Layout)> layouts = new(16);
    private VkImageMemoryBarrier2[] transitions = new VkImageMemoryBarrier2[16];
    private VkPipelineStageFlags2 pendingStages;
    private VkPipelineStageFlags2 nextStages;
    private ulong command = 1;
    private ulong barrier, computeBarrier, indirectBarrier;
    private bool collides;
    // Since the last barrier for all stages.
    private VkPipelineStageFlags2 unordered;
    private bool usedTextures;

    public long BarrierCount { get; private set; }

    /// <summary>Those of them that name the compute stage alone, and indirect arguments where the command reads some.</summary>
    public long ComputeBarrierCount { get; private set; }

    /// <summary>Whether the accesses gathered so far need a barrier.</summary>
    public bool NeedsBarrier
    {
        get
        {
            if (collides)
            {
                return true;
            }

            foreach ((GpuTexture texture, VkImageLayout layout) in layouts)
            {
                if (texture.Layout != layout)
                {
                    return true;
                }
            }

            return false;
        }
    }

    /// <summary>The coming command reads a resource.</summary>
    public void Read(GpuResource resource, VkPipelineStageFlags2 stages)
    {
        resource.ThrowIfDisposed();
        collides |= resource.LastWrite > BarrierFor(stages);
        nextStages |= stages;
        accesses.Add((resource, false));
    }

    /// <summary>The coming command writes a resource (and may read it).</summary>
    public void Write(GpuResource resource, VkPipelineStageFlags2 stages)
    {
        resource.ThrowIfDisposed();
        collides |= Math.Max(resource.LastWrite, resource.LastRead) > BarrierFor(stages);
        nextStages |= stages;
        accesses.Add((resource, true));
    }

    /// <summary>The coming command uses a texture in a layout.</summary>
    public void Use(GpuTexture texture, VkImageLayout layout, bool write, VkPipelineStageFlags2 stages)
    {
        foreach ((GpuTexture other, VkImageLayout otherLayout) in layouts)
        {
            if (ReferenceEquals(other, texture))
            {
                if (otherLayout != layout)
                {
                    accesses.Clear();
                    layouts.Clear();
                    throw new GpuException($"Texture '{texture.Name}' is bound for reading and as a target in one command; read from a copy.");
                }

                return;
            }
        }

        if (write)
        {
            Write(texture, stages);
        }
        else
        {
            Read(texture, stages);
        }

        layouts.Add((texture, layout));
    }

    /// <summary>Records the barrier, if one is needed, and counts the command.</summary>
    public void Commit(VkCommandBuffer commands)
    {
        if (NeedsBarrier)
        {
            Record(commands);
        }

        foreach ((GpuResource resource, bool write) in accesses)
        {
            if (write)
            {
                resource.LastWrite = command;
            }
            else
            {
                resource.LastRead = command;
            }
        }

        pendingStages |= nextStages;
        unordered |= nextStages;
        usedTextures |= layouts.Count > 0;
        command++;
        Forget();
    }

    /// <summary>Drops what was gathered for a command that is not recorded after all.</summary>
    public void Forget()
    {
        nextStages = 0;
        collides = false;
        accesses.Clear();
        layouts.Clear();
    }

    // Number of the last barrier that orders a command's stages; a command may have several.
    private ulong BarrierFor(VkPipelineStageFlags2 stages) => (stages & ~(Compute | Indirect)) != 0 || stages == 0
        ? barrier
        : Math.Min((stages & Compute) != 0 ? computeBarrier : ulong.MaxValue, (stages & Indirect) != 0 ? indirectBarrier : ulong.MaxValue);

    private static bool IsCompute(VkPipelineStageFlags2 stages) => (stages & Compute) != 0 && (stages & ~(Compute | Indirect)) == 0;

    private void Record(VkCommandBuffer commands)
    {
        if (IsCompute(pendingStages) && IsCompute(nextStages) && !usedTextures && layouts.Count == 0) RecordCompute(commands);
        else RecordAll(commands);
        pendingStages = 0;
        BarrierCount++;
    }

    private void RecordCompute(VkCommandBuffer commands)
    {
        bool indirect = (nextStages & Indirect) != 0;
        VkMemoryBarrier2 memory = new()
        {
            srcStageMask = pendingStages,
            srcAccessMask = VkAccessFlags2.ShaderStorageWrite,
            dstStageMask = indirect ? Compute | Indirect : Compute,
            dstAccessMask = VkAccessFlags2.ShaderStorageRead | VkAccessFlags2.ShaderStorageWrite | VkAccessFlags2.UniformRead
                | (indirect ? VkAccessFlags2.IndirectCommandRead : VkAccessFlags2.None),
        };
        VkDependencyInfo info = new() { memoryBarrierCount = 1, pMemoryBarriers = &memory };
        Vk.vkCmdPipelineBarrier2(commands, &info);
        computeBarrier = command - 1;
        if (indirect) indirectBarrier = command - 1;
        ComputeBarrierCount++;
    }

    private void RecordAll(VkCommandBuffer commands)
    {
        VkPipelineStageFlags2 source = pendingStages == 0 ? VkPipelineStageFlags2.AllCommands : pendingStages | unordered;
        uint count = 0;
        foreach ((GpuTexture texture, VkImageLayout layout) in layouts)
        {
            if (texture.Layout != layout)
            {
                if (count == transitions.Length)
                {
                    Array.Resize(ref transitions, transitions.Length * 2);
                }

                transitions[count++] = Transition(texture, layout, source);
                texture.Layout = layout;
            }
        }

        VkMemoryBarrier2 memory = new()
        {
            srcStageMask = source,
            srcAccessMask = VkAccessFlags2.MemoryWrite,
            dstStageMask = VkPipelineStageFlags2.AllCommands,
            dstAccessMask = AllAccess,
        };
        fixed (VkImageMemoryBarrier2* images = transitions)
        {
            VkDependencyInfo info = new()
            {
                memoryBarrierCount = 1,
                pMemoryBarriers = &memory,
                imageMemoryBarrierCount = count,
                pImageMemoryBarriers = images,
            };
            Vk.vkCmdPipelineBarrier2(commands, &info);
        }

        barrier = computeBarrier = indirectBarrier = command - 1;
        unordered = 0;
        usedTextures = false;
    }

    private static VkImageMemoryBarrier2 Transition(GpuTexture texture, VkImageLayout layout, VkPipelineStageFlags2 source) => new()
    {
        srcStageMask = source,
        srcAccessMask = VkAccessFlags2.MemoryWrite,
        dstStageMask = VkPipelineStageFlags2.AllCommands,
        dstAccessMask = AllAccess,
        oldLayout = texture.Layout,
        newLayout = layout,
        srcQueueFamilyIndex = uint.MaxValue,
        dstQueueFamilyIndex = uint.MaxValue,
        image = texture.Handle,
        subresourceRange = texture.WholeRange,
    };
}
