using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>Which features are switched on: the needed ones or a named error, and every core feature that there is.</summary>
internal sealed record DeviceFeatures(VkPhysicalDeviceFeatures Core, bool MirrorOnce, bool Robustness2, bool Executables, bool Layers)
{
    private const string RobustnessExtension = "VK_EXT_robustness2";
    private const string LayerExtension = "VK_EXT_shader_viewport_index_layer";
    private const string ExecutableExtension = "VK_KHR_pipeline_executable_properties";
    private const uint Version13 = (1u << 22) | (3u << 12);

    public IReadOnlyList<string> Extensions =>
    [
        .. Robustness2 ? [RobustnessExtension] : Array.Empty<string>(), .. Executables ? [ExecutableExtension] : Array.Empty<string>(),
        .. Layers ? [LayerExtension] : Array.Empty<string>(),
    ];

    /// <summary>What a pipeline is created with.</summary>
    public VkPipelineCreateFlags PipelineFlags => Executables
        ? VkPipelineCreateFlags.CaptureStatistics | VkPipelineCreateFlags.CaptureInternalRepresentations
        : VkPipelineCreateFlags.None;

    /// <summary>Reads what there is; throws when something needed is missing.</summary>
    public static unsafe DeviceFeatures Read(PhysicalAdapter adapter, bool executables)
    {
        if (adapter.Properties.apiVersion < Version13)
        {
            throw new GpuException($"Device '{adapter.Info.Name}' speaks Vulkan {adapter.Info.ApiVersion}; 1.3 is needed. Update its driver or choose another device.");
        }

        VkPhysicalDeviceRobustness2FeaturesEXT robust = new();
        VkPhysicalDeviceVulkan13Features v13 = new();
        VkPhysicalDeviceVulkan12Features v12 = new() { pNext = &v13 };
        VkPhysicalDeviceFeatures2 all = new() { pNext = &v12 };
        bool robustness = HasExtension(adapter.Handle, RobustnessExtension);
        v13.pNext = robustness ? &robust : null;
        Vk.vkGetPhysicalDeviceFeatures2(adapter.Handle, &all);
        Require(adapter, v12.scalarBlockLayout, "scalarBlockLayout");
        Require(adapter, v13.dynamicRendering, "dynamicRendering");
        Require(adapter, v13.synchronization2, "synchronization2");
        Require(adapter, all.features.robustBufferAccess, "robustBufferAccess");
        if (executables && !HasExtension(adapter.Handle, ExecutableExtension))
        {
            throw new GpuException($"Device '{adapter.Info.Name}' does not report compiled programs ({ExecutableExtension}). Choose another device.");
        }

        bool exactBounds = robustness && robust.robustBufferAccess2 != 0;
        bool layers = v12.shaderOutputLayer != 0 && v12.shaderOutputViewportIndex != 0 && HasExtension(adapter.Handle, LayerExtension);
        return new DeviceFeatures(all.features, v12.samplerMirrorClampToEdge != 0, exactBounds, executables, layers);
    }

    /// <summary>Accesses outside a buffer do what the device does, not what D3D11 says.</summary>
    public DeviceFeatures WithoutRobustAccess()
    {
        VkPhysicalDeviceFeatures core = Core;
        core.robustBufferAccess = 0;
        return this with { Core = core, Robustness2 = false };
    }

    /// <summary>Fills the chain for device creation; the structs must stay where they are until then.</summary>
    public unsafe void Write(
        VkPhysicalDeviceFeatures2* core, VkPhysicalDeviceVulkan12Features* v12, VkPhysicalDeviceVulkan13Features* v13,
        VkPhysicalDeviceRobustness2FeaturesEXT* robust, VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR* executables)
    {
        core->pNext = v12;
        v12->pNext = v13;
        executables->pNext = Robustness2 ? robust : null;
        v13->pNext = Executables ? executables : executables->pNext;
        core->features = Core;
        v12->scalarBlockLayout = 1;
        v12->samplerMirrorClampToEdge = MirrorOnce ? 1u : 0u;
        v12->shaderOutputLayer = v12->shaderOutputViewportIndex = Layers ? 1u : 0u;
        v13->dynamicRendering = 1;
        v13->synchronization2 = 1;
        robust->robustBufferAccess2 = 1;
        executables->pipelineExecutableInfo = 1;
    }

    private static void Require(PhysicalAdapter adapter, uint feature, string name)
    {
        if (feature == 0)
        {
            throw new GpuException($"Device '{adapter.Info.Name}' has no Vulkan feature {name}. Update its driver or choose another device.");
        }
    }

    private static unsafe bool HasExtension(VkPhysicalDevice device, string name)
    {
        uint count;
        Vk.vkEnumerateDeviceExtensionProperties(device, null, &count, null).Check("Listing device extensions");
        VkExtensionProperties[] list = new VkExtensionProperties[count];
        fixed (VkExtensionProperties* first = list)
        {
            Vk.vkEnumerateDeviceExtensionProperties(device, null, &count, first).Check("Listing device extensions");
            for (uint i = 0; i < count; i++)
            {
                if (Utf8Texts.Read(first[i].extensionName) == name)
                {
                    return true;
                }
            }
        }

        return false;
    }
}
