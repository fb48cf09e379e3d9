using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>The Vulkan instance, with the validation layer and its messages when asked for.</summary>
internal sealed unsafe class VulkanInstance : IDisposable
{
    private const string ValidationLayer = "VK_LAYER_KHRONOS_validation";
    private const string DebugUtils = "VK_EXT_debug_utils";
    private const uint Version13 = (1u << 22) | (3u << 12);

    private readonly DebugMessenger? messenger;

    public VulkanInstance(bool validate, bool synchronization)
    {
        VulkanLibrary.EnsureLoaded();
        RequireVersion();
        if (validate && !HasValidationLayer())
        {
            throw new GpuException(
                $"Validation was asked for, but the layer {ValidationLayer} is not installed; on Debian: apt install vulkan-validationlayers.");
        }

        using Utf8Texts texts = new();
        byte** layers = stackalloc byte*[1];
        byte** extensions = stackalloc byte*[1];
        VkApplicationInfo application = new() { pApplicationName = texts.Add("sphplayer"), apiVersion = Version13 };
        VkInstanceCreateInfo info = new() { pApplicationInfo = &application };
        VkValidationFeatureEnableEXT enabled = VkValidationFeatureEnableEXT.SynchronizationValidation;
        VkValidationFeaturesEXT features = new() { enabledValidationFeatureCount = 1, pEnabledValidationFeatures = &enabled };
        if (validate)
        {
            layers[0] = texts.Add(ValidationLayer);
            extensions[0] = texts.Add(DebugUtils);
            info.enabledLayerCount = 1;
            info.ppEnabledLayerNames = layers;
            info.enabledExtensionCount = 1;
            info.ppEnabledExtensionNames = extensions;
            info.pNext = synchronization ? &features : null;
        }

        VkInstance handle;
        Vk.vkCreateInstance(&info, null, &handle).Check("Starting Vulkan");
        Handle = handle;
        if (validate)
        {
            LoadExtensions();
            messenger = new DebugMessenger(handle, Extensions);
        }
    }

    public VkInstance Handle { get; }

    /// <summary>Function pointers; null without validation.</summary>
    public VkExtensions Extensions { get; private set; }

    public bool Validates => messenger is not null;

    public IReadOnlyList<string> Messages => messenger?.Snapshot() ?? [];

    public void Dispose()
    {
        messenger?.Dispose();
        Vk.vkDestroyInstance(Handle, null);
    }

    private static void RequireVersion()
    {
        uint version;
        Vk.vkEnumerateInstanceVersion(&version).Check("Asking for the Vulkan version");
        if (version < Version13)
        {
            throw new GpuException($"The Vulkan loader speaks {DeviceText.Version(version)}; 1.3 is needed. Update the Vulkan loader and driver.");
        }
    }

    private static bool HasValidationLayer()
    {
        uint count;
        Vk.vkEnumerateInstanceLayerProperties(&count, null).Check("Listing Vulkan layers");
        VkLayerProperties[] layers = new VkLayerProperties[count];
        fixed (VkLayerProperties* first = layers)
        {
            Vk.vkEnumerateInstanceLayerProperties(&count, first).Check("Listing Vulkan layers");
            for (uint i = 0; i < count; i++)
            {
                if (Utf8Texts.Read(first[i].layerName) == ValidationLayer)
                {
                    return true;
                }
            }
        }

        return false;
    }

    private void LoadExtensions()
    {
        VkExtensions table = default;
        table.vkCreateDebugUtilsMessengerEXT = (delegate* unmanaged<VkInstance, VkDebugUtilsMessengerCreateInfoEXT*, VkAllocationCallbacks*, VkDebugUtilsMessengerEXT*, VkResult>)Find("vkCreateDebugUtilsMessengerEXT");
        table.vkDestroyDebugUtilsMessengerEXT = (delegate* unmanaged<VkInstance, VkDebugUtilsMessengerEXT, VkAllocationCallbacks*, void>)Find("vkDestroyDebugUtilsMessengerEXT");
        table.vkSetDebugUtilsObjectNameEXT = (delegate* unmanaged<VkDevice, VkDebugUtilsObjectNameInfoEXT*, VkResult>)Find("vkSetDebugUtilsObjectNameEXT");
        Extensions = table;
    }

    /// <summary>Functions of VK_KHR_pipeline_executable_properties, for a device that has it.</summary>
    public VkExtensions LoadExecutableFunctions() => Extensions with
    {
        vkGetPipelineExecutablePropertiesKHR = (delegate* unmanaged<VkDevice, VkPipelineInfoKHR*, uint*, VkPipelineExecutablePropertiesKHR*, VkResult>)Find("vkGetPipelineExecutablePropertiesKHR"),
        vkGetPipelineExecutableStatisticsKHR = (delegate* unmanaged<VkDevice, VkPipelineExecutableInfoKHR*, uint*, VkPipelineExecutableStatisticKHR*, VkResult>)Find("vkGetPipelineExecutableStatisticsKHR"),
        vkGetPipelineExecutableInternalRepresentationsKHR = (delegate* unmanaged<VkDevice, VkPipelineExecutableInfoKHR*, uint*, VkPipelineExecutableInternalRepresentationKHR*, VkResult>)Find("vkGetPipelineExecutableInternalRepresentationsKHR"),
    };

    private nint Find(string name)
    {
        using Utf8Texts texts = new();
        nint address = Vk.vkGetInstanceProcAddr(Handle, texts.Add(name));
        return address != 0 ? address : throw new GpuException($"The Vulkan loader has no {name}; update it.");
    }
}
