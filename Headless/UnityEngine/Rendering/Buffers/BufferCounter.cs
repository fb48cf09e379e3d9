using System;
using Headless.Vulkan;

namespace Headless.Engine;

/// <summary>The hidden counter of append, consume and counted buffers, as D3D11 keeps it beside the buffer.</summary>
internal static class BufferCounter
{
    public static GpuBuffer Create(string name, uint value)
    {
        GpuBuffer counter = GraphicsDevice.Device.CreateBuffer(sizeof(uint), BufferUse.Storage, name + " counter");
        Set(counter, value);
        return counter;
    }

    public static void Set(GpuBuffer counter, uint value) => GraphicsDevice.Recorder.FillBuffer(counter, 0, sizeof(uint), value);

    public static void Set(DeviceBuffer buffer, uint value) => Set(Of(buffer, "SetCounterValue"), value);

    /// <exception cref="ArgumentException">The offset is no multiple of 4 or beyond the target, or the source counts nothing.</exception>
    public static void Copy(DeviceBuffer source, DeviceBuffer target, long offset)
    {
        if (offset < 0 || offset % 4 != 0 || offset + sizeof(uint) > target.ByteSize)
        {
            throw new ArgumentException(
                $"CopyCount: byte {offset} must be a multiple of 4 that leaves 4 bytes in '{target.Name}' of {target.ByteSize} bytes.");
        }

        GraphicsDevice.Recorder.CopyBuffer(Of(source, "CopyCount"), 0, target.Gpu, offset, sizeof(uint));
    }

    private static GpuBuffer Of(DeviceBuffer buffer, string method)
    {
        _ = buffer.Gpu;
        return buffer.Counter ?? throw new ArgumentException(
            $"{method}: '{buffer.Name}' has no counter: create it as Append or Counter.");
    }
}
