using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>Descriptor sets of one submission, shared by content, all given back at once.</summary>
internal sealed unsafe class DescriptorArena(DeviceContext context) : IDisposable
{
    private const uint SetsPerPool = 512;

    private readonly List<VkDescriptorPool> pools = [];
    private readonly Dictionary<ulong, List<(ulong[] Content, VkDescriptorSet Set)>> sets = [];
    private readonly DescriptorWriter writer = new(context);
    private int active;

    /// <summary>The set of a layout whose descriptors are <paramref name="content"/>; written on first sight.</summary>
    public VkDescriptorSet Get(StageLayout layout, ReadOnlySpan<ulong> content)
    {
        ulong hash = layout.Handle.Handle;
        foreach (ulong word in content)
        {
            hash = (hash ^ word) * 0x9E3779B97F4A7C15;
            hash ^= hash >> 32;
        }

        if (!sets.TryGetValue(hash, out List<(ulong[] Content, VkDescriptorSet Set)>? entries))
        {
            sets[hash] = entries = new(1);
        }

        foreach ((ulong[] known, VkDescriptorSet set) in entries)
        {
            if (known[^1] == layout.Handle.Handle && content.SequenceEqual(known.AsSpan(0, known.Length - 1)))
            {
                return set;
            }
        }

        VkDescriptorSet fresh = Allocate(layout.Handle);
        writer.Write(fresh, layout, content);
        entries.Add(([.. content, layout.Handle.Handle], fresh));
        return fresh;
    }

    public void Reset()
    {
        sets.Clear();
        for (int i = 0; i < pools.Count && i <= active; i++)
        {
            Vk.vkResetDescriptorPool(context.Handle, pools[i], 0).Check("Resetting a descriptor pool");
        }

        active = 0;
    }

    public void Dispose()
    {
        pools.ForEach(pool => Vk.vkDestroyDescriptorPool(context.Handle, pool, null));
        pools.Clear();
    }

    private VkDescriptorSet Allocate(VkDescriptorSetLayout layout)
    {
        bool freshPool = false;
        while (true)
        {
            if (active == pools.Count)
            {
                pools.Add(CreatePool());
                freshPool = true;
            }

            VkDescriptorSetAllocateInfo info = new() { descriptorPool = pools[active], descriptorSetCount = 1, pSetLayouts = &layout };
            VkDescriptorSet set;
            VkResult result = Vk.vkAllocateDescriptorSets(context.Handle, &info, &set);
            if (!freshPool && (result is VkResult.ErrorOutOfPoolMemory or VkResult.ErrorFragmentedPool))
            {
                active++;
                continue;
            }

            result.Check("Allocating descriptors");
            return set;
        }
    }

    private VkDescriptorPool CreatePool()
    {
        VkDescriptorPoolSize* sizes = stackalloc VkDescriptorPoolSize[5];
        sizes[0] = Size(VkDescriptorType.StorageBuffer, 16);
        sizes[1] = Size(VkDescriptorType.UniformBufferDynamic, 8);
        sizes[2] = Size(VkDescriptorType.SampledImage, 8);
        sizes[3] = Size(VkDescriptorType.StorageImage, 4);
        sizes[4] = Size(VkDescriptorType.Sampler, 8);
        VkDescriptorPoolCreateInfo info = new() { maxSets = SetsPerPool, poolSizeCount = 5, pPoolSizes = sizes };
        VkDescriptorPool pool;
        Vk.vkCreateDescriptorPool(context.Handle, &info, null, &pool).Check("Creating a descriptor pool");
        return pool;
    }

    private static VkDescriptorPoolSize Size(VkDescriptorType type, uint perSet) =>
        new() { type = type, descriptorCount = perSet * SetsPerPool };
}
