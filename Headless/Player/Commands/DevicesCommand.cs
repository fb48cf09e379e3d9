using Headless.Vulkan;

namespace Headless.Player.Commands;

/// <summary>Lists the graphics devices; <c>--device</c> takes an index or a part of a name.</summary>
internal static class DevicesCommand
{
    public static int Run(IReadOnlyList<string> words)
    {
        _ = new Arguments("devices", words, []);
        IReadOnlyList<AdapterInfo> adapters = GpuDevice.Enumerate();
        if (adapters.Count == 0) throw new GpuException("there is no Vulkan driver. Debian: apt install mesa-vulkan-drivers; others: the driver of the graphics card's maker.");
        foreach (AdapterInfo adapter in adapters) Console.WriteLine(adapter);
        return 0;
    }
}
