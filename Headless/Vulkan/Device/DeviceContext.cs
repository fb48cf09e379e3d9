using Headless.Shaders;
using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>The logical device with its one queue, memory and limits; every part of this layer holds it.</summary>
internal sealed unsafe class DeviceContext : IDisposable
{
    private DeviceContext(VulkanInstance instance, PhysicalAdapter physical, DeviceFeatures features, bool poisons)
    {
        Poisons = poisons;
        Instance = instance;
        Physical = physical;
        Features = features;
        Limits = LimitReader.Read(physical, features, out uint family, out TimestampClock timestamps);
        QueueFamily = family;
        Timestamps = timestamps;
        Handle = CreateDevice();
        VkQueue queue;
        Vk.vkGetDeviceQueue(Handle, family, 0, &queue);
        Queue = queue;
        Memory = new MemoryAllocator(this);
    }

    public VulkanInstance Instance { get; }

    public PhysicalAdapter Physical { get; }

    public DeviceFeatures Features { get; }

    public AdapterInfo Adapter => Physical.Info;

    public GpuLimits Limits { get; }

    public VkDevice Handle { get; }

    public VkQueue Queue { get; }

    public uint QueueFamily { get; }

    public TimestampClock Timestamps { get; }

    public MemoryAllocator Memory { get; }

    /// <summary>Whether new memory holds set bits in place of zeros.</summary>
    public bool Poisons { get; }

    /// <summary>Takes what shaders find outside their buffers; null where indices are not checked.</summary>
    public BoundsLog? Bounds { get; set; }

    /// <summary>Buffers and textures that are not disposed.</summary>
    public HashSet<GpuResource> Resources { get; } = [];

    /// <param name="captureExecutables">Keeps what <see cref="ExecutableReader"/> reads; the driver needs an extension for it.</param>
    public static DeviceContext Open(GpuDeviceOptions options, bool captureExecutables = false)
    {
        VulkanInstance instance = new(options.Validate, options.ValidateSynchronization);
        try
        {
            PhysicalAdapter physical = AdapterList.Choose(AdapterList.Read(instance), options.Adapter);
            DeviceFeatures features = DeviceFeatures.Read(physical, captureExecutables);
            features = options.CheckBounds ? features.WithoutRobustAccess() : features;
            return new DeviceContext(instance, physical, features, options.Poison);
        }
        catch
        {
            instance.Dispose();
            throw;
        }
    }

    /// <summary>Whether the device is a rasterizer that runs on the CPU.</summary>
    public bool OnProcessor => Adapter.Type == "Cpu";

    /// <summary>
    /// The shader as it runs: compiled once on a CPU, and with poisoned groupshared memory and checked indices where the device is to have them.
    /// </summary>
    public ShaderBinary Instrument(ShaderBinary shader)
    {
        shader = OnProcessor ? ConstantConditions.Apply(shader) : shader;
        shader = Bounds is null ? shader : BoundsCheck.Apply(shader, Bounds.Register);
        return Poisons ? SharedMemoryPoison.Apply(shader) : shader;
    }

    /// <summary>Gives a Vulkan object its name in validation messages and captures.</summary>
    public void SetName(VkObjectType type, ulong handle, string name)
    {
        if (!Instance.Validates || name.Length == 0)
        {
            return;
        }

        using Utf8Texts texts = new();
        VkDebugUtilsObjectNameInfoEXT info = new() { objectType = type, objectHandle = handle, pObjectName = texts.Add(name) };
        Instance.Extensions.vkSetDebugUtilsObjectNameEXT(Handle, &info).Check("Naming an object");
    }

    public void Dispose()
    {
        Memory.Dispose();
        Vk.vkDestroyDevice(Handle, null);
        Instance.Dispose();
    }

    private VkDevice CreateDevice()
    {
        float priority = 1;
        VkDeviceQueueCreateInfo queue = new() { queueFamilyIndex = QueueFamily, queueCount = 1, pQueuePriorities = &priority };
        VkPhysicalDeviceFeatures2 core = new();
        VkPhysicalDeviceVulkan12Features v12 = new();
        VkPhysicalDeviceVulkan13Features v13 = new();
        VkPhysicalDeviceRobustness2FeaturesEXT robust = new();
        VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR executables = new();
        Features.Write(&core, &v12, &v13, &robust, &executables);
        using Utf8Texts texts = new();
        byte** extensions = stackalloc byte*[4];
        texts.AddAll(Features.Extensions, extensions);
        VkDeviceCreateInfo info = new()
        {
            pNext = &core,
            queueCreateInfoCount = 1,
            pQueueCreateInfos = &queue,
            enabledExtensionCount = (uint)Features.Extensions.Count,
            ppEnabledExtensionNames = extensions,
        };
        VkDevice device;
        Vk.vkCreateDevice(Physical.Handle, &info, null, &device).Check($"Opening '{Adapter.Name}'");
        return device;
    }
}
