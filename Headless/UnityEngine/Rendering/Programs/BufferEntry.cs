using Headless.Shaders;
using Headless.Vulkan;

namespace Headless.Engine;

/// <summary>A buffer as a stage declares it.</summary>
/// <param name="Stride">Bytes of an element of a structured buffer.</param>
/// <param name="Register">Number n of register(un) of a buffer that is written; -1 for others.</param>
internal readonly record struct BufferEntry(int NameId, string Name, int Binding, ResourceKind Kind, int Stride, int Register)
{
    /// <summary>Whether it stands for the hidden counter of the buffer of that name.</summary>
    public bool IsCounter => Kind == ResourceKind.Counter;

    /// <summary>What is bound of a buffer that fits.</summary>
    public GpuBuffer Of(DeviceBuffer buffer) => IsCounter ? buffer.Counter! : buffer.Gpu;
}
