using System.Globalization;
using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>Lists the machine's Vulkan devices and picks one.</summary>
internal static unsafe class AdapterList
{
    private static readonly string[] Preference = ["DiscreteGpu", "IntegratedGpu", "VirtualGpu", "Other", "Cpu"];

    public static IReadOnlyList<PhysicalAdapter> Read(VulkanInstance instance)
    {
        uint count;
        VkResult result = Vk.vkEnumeratePhysicalDevices(instance.Handle, &count, null);
        if (result == VkResult.ErrorInitializationFailed)
        {
            return [];
        }

        result.Check("Listing Vulkan devices");
        VkPhysicalDevice[] handles = new VkPhysicalDevice[count];
        fixed (VkPhysicalDevice* first = handles)
        {
            Vk.vkEnumeratePhysicalDevices(instance.Handle, &count, first).Check("Listing Vulkan devices");
        }

        return handles.Select(Describe).ToList();
    }

    /// <summary>The device of an index or name part; without either the first of the best kind.</summary>
    public static PhysicalAdapter Choose(IReadOnlyList<PhysicalAdapter> adapters, string? requested)
    {
        if (adapters.Count == 0)
        {
            throw new GpuException("No Vulkan device on this machine. Install a driver; on Debian: apt install mesa-vulkan-drivers.");
        }

        if (string.IsNullOrWhiteSpace(requested))
        {
            return adapters.MinBy(adapter => Array.IndexOf(Preference, adapter.Info.Type))!;
        }

        bool byIndex = int.TryParse(requested, NumberStyles.None, CultureInfo.InvariantCulture, out int index);
        return adapters.FirstOrDefault(adapter => byIndex
                ? adapter.Info.Index == index
                : adapter.Info.Name.Contains(requested, StringComparison.OrdinalIgnoreCase))
            ?? throw new UnknownAdapterException($"No Vulkan device '{requested}'. There is: {string.Join("; ", adapters.Select(adapter => adapter.Info))}.");
    }

    private static PhysicalAdapter Describe(VkPhysicalDevice handle, int index)
    {
        VkPhysicalDeviceVulkan12Properties driver = new();
        VkPhysicalDeviceVulkan11Properties identity = new() { pNext = &driver };
        VkPhysicalDeviceProperties2 properties = new() { pNext = &identity };
        Vk.vkGetPhysicalDeviceProperties2(handle, &properties);
        VkPhysicalDeviceProperties core = properties.properties;
        string driverText = $"{Utf8Texts.Read(driver.driverName)} {Utf8Texts.Read(driver.driverInfo)}".Trim();
        AdapterInfo info = new(index, Utf8Texts.Read(core.deviceName), driverText, DeviceText.Type(core.deviceType),
            DeviceText.Version(core.apiVersion), (int)core.vendorID, (int)core.deviceID);
        string key = Convert.ToHexStringLower(new ReadOnlySpan<byte>(core.pipelineCacheUUID, 16));
        return new PhysicalAdapter(handle, info, core, $"{core.vendorID:x4}-{core.deviceID:x4}-{key}");
    }
}
