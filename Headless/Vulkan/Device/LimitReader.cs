using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>Collects the limits that callers ask for, and the queue that does all work.</summary>
internal static unsafe class LimitReader
{
    public static GpuLimits Read(PhysicalAdapter adapter, DeviceFeatures features, out uint family, out TimestampClock timestamps)
    {
        VkPhysicalDeviceVulkan11Properties v11 = new();
        VkPhysicalDeviceProperties2 properties = new() { pNext = &v11 };
        Vk.vkGetPhysicalDeviceProperties2(adapter.Handle, &properties);
        VkPhysicalDeviceLimits limits = properties.properties.limits;
        VkQueueFamilyProperties queue = FindQueue(adapter, out family);
        timestamps = new TimestampClock(limits.timestampPeriod, (int)queue.timestampValidBits);
        return new GpuLimits
        {
            MaxStorageBufferRange = limits.maxStorageBufferRange,
            MaxUniformBufferRange = limits.maxUniformBufferRange,
            MaxAllocationSize = (long)Math.Min(v11.maxMemoryAllocationSize, long.MaxValue),
            DeviceMemory = DeviceMemory(adapter),
            MaxComputeGroupInvocations = (int)limits.maxComputeWorkGroupInvocations,
            MaxComputeGroupSize = ((int)limits.maxComputeWorkGroupSize[0], (int)limits.maxComputeWorkGroupSize[1], (int)limits.maxComputeWorkGroupSize[2]),
            MaxGroupCount = (limits.maxComputeWorkGroupCount[0], limits.maxComputeWorkGroupCount[1], limits.maxComputeWorkGroupCount[2]),
            MaxSharedMemory = (int)limits.maxComputeSharedMemorySize,
            MaxStorageBuffersPerStage = (int)Math.Min(limits.maxPerStageDescriptorStorageBuffers, int.MaxValue),
            MaxStorageImagesPerStage = (int)Math.Min(limits.maxPerStageDescriptorStorageImages, int.MaxValue),
            MaxUniformBuffersPerPipeline = (int)Math.Min(limits.maxDescriptorSetUniformBuffersDynamic, int.MaxValue),
            MaxTexture2D = (int)limits.maxImageDimension2D,
            MaxTexture3D = (int)limits.maxImageDimension3D,
            MaxTextureLayers = (int)limits.maxImageArrayLayers,
            MaxColorTargets = (int)limits.maxColorAttachments,
            GeometryShader = features.Core.geometryShader != 0,
            MaxGeometryOutputVertices = features.Core.geometryShader != 0 ? (int)limits.maxGeometryOutputVertices : 0,
            VertexStageWrites = features.Core.vertexPipelineStoresAndAtomics != 0,
            Timestamps = queue.timestampValidBits > 0 && limits.timestampPeriod > 0,
            SampleCounts = (int)(limits.framebufferColorSampleCounts & limits.framebufferDepthSampleCounts),
            StorageBufferOffsetAlignment = (int)limits.minStorageBufferOffsetAlignment,
        };
    }

    private static VkQueueFamilyProperties FindQueue(PhysicalAdapter adapter, out uint family)
    {
        uint count;
        Vk.vkGetPhysicalDeviceQueueFamilyProperties(adapter.Handle, &count, null);
        VkQueueFamilyProperties[] families = new VkQueueFamilyProperties[count];
        fixed (VkQueueFamilyProperties* first = families)
        {
            Vk.vkGetPhysicalDeviceQueueFamilyProperties(adapter.Handle, &count, first);
        }

        const VkQueueFlags Needed = VkQueueFlags.Graphics | VkQueueFlags.Compute;
        int index = Array.FindIndex(families, candidate => (candidate.queueFlags & Needed) == Needed);
        if (index < 0)
        {
            throw new GpuException($"Device '{adapter.Info.Name}' has no queue for both drawing and compute. Choose another device.");
        }

        family = (uint)index;
        return families[index];
    }

    private static long DeviceMemory(PhysicalAdapter adapter)
    {
        VkPhysicalDeviceMemoryProperties memory;
        Vk.vkGetPhysicalDeviceMemoryProperties(adapter.Handle, &memory);
        ulong largest = 0;
        for (int i = 0; i < memory.memoryHeapCount; i++)
        {
            if (memory.memoryHeaps[i].flags.HasFlag(VkMemoryHeapFlags.DeviceLocal))
            {
                largest = Math.Max(largest, memory.memoryHeaps[i].size);
            }
        }

        return (long)largest;
    }
}
