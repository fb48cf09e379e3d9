namespace Headless.Vulkan;

/// <summary>A Vulkan device of this machine, as <see cref="GpuDevice.Enumerate"/> lists it.</summary>
/// <param name="Index">Position in the loader's list; <c>--device INDEX</c> takes it.</param>
/// <param name="Name">The driver's name of the device, for example "llvmpipe (LLVM 15.0.6, 256 bits)".</param>
/// <param name="Driver">Driver name and version text.</param>
/// <param name="Type">DiscreteGpu, IntegratedGpu, VirtualGpu, Cpu or Other.</param>
/// <param name="ApiVersion">Highest Vulkan version the device speaks, for example "1.3.230".</param>
/// <param name="VendorId">Number of the vendor, for example 0x10de.</param>
/// <param name="DeviceId">The vendor's number of the device.</param>
public sealed record AdapterInfo(int Index, string Name, string Driver, string Type, string ApiVersion, int VendorId = 0, int DeviceId = 0)
{
    /// <summary>One line for lists and error messages.</summary>
    public override string ToString() => $"{Index}: {Name} [{Type}, Vulkan {ApiVersion}, {Driver}]";
}
