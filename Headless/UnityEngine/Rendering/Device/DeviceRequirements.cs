using System.Linq;
using Headless.Shaders;

namespace Headless.Engine;

/// <summary>Holds a kernel's needs against the device's limits.</summary>
internal static class DeviceRequirements
{
    public static string? WhyUnsupported(ShaderBinary binary)
    {
        Headless.Vulkan.GpuLimits limits = GraphicsDevice.Device.Limits;
        long threads = (long)binary.GroupX * binary.GroupY * binary.GroupZ;
        if (threads > limits.MaxComputeGroupInvocations)
        {
            return $"a group of {threads} threads exceeds the device's {limits.MaxComputeGroupInvocations}";
        }

        if (binary.SharedBytes > limits.MaxSharedMemory)
        {
            return $"{binary.SharedBytes} bytes of groupshared memory exceed the device's {limits.MaxSharedMemory}";
        }

        int buffers = binary.Resources.Count(r => r.Kind is ResourceKind.StructuredBuffer or ResourceKind.RWStructuredBuffer
            or ResourceKind.ByteAddressBuffer or ResourceKind.RWByteAddressBuffer);
        return buffers > limits.MaxStorageBuffersPerStage
            ? $"{buffers} buffers exceed the device's {limits.MaxStorageBuffersPerStage} a stage"
            : null;
    }
}
