using System.Reflection;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

[assembly: DisableRuntimeMarshalling]

namespace Headless.Vulkan.Native;

/// <summary>Finds the Vulkan loader under the names that systems give it.</summary>
internal static class VulkanLibrary
{
    public const string Name = "vulkan";

    private static readonly string[] FileNames = ["libvulkan.so.1", "vulkan-1.dll", "libvulkan.1.dylib", "libvulkan.so"];
    private static readonly Lazy<nint> Handle = new(Load);

    static VulkanLibrary() => NativeLibrary.SetDllImportResolver(typeof(VulkanLibrary).Assembly, Resolve);

    /// <summary>Loads the library once; a clear error without it.</summary>
    public static void EnsureLoaded() => _ = Handle.Value;

    private static nint Resolve(string name, Assembly assembly, DllImportSearchPath? path) => name == Name ? Handle.Value : 0;

    private static nint Load()
    {
        foreach (string file in FileNames)
        {
            if (NativeLibrary.TryLoad(file, out nint handle))
            {
                return handle;
            }
        }

        throw new GpuException(
            "No Vulkan loader (libvulkan.so.1) on this machine. Install it and a driver; on Debian: apt install libvulkan1 mesa-vulkan-drivers.");
    }
}
