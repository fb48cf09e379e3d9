using System.Linq;
using System.Runtime.InteropServices;
using System;
using Headless.Vulkan;

namespace Headless.Engine;

/// <summary>An index buffer that draws quads as pairs of triangles; grows to the largest count asked for.</summary>
internal static class QuadIndices
{
    private static DeviceBuffer? buffer;
    private static int capacity;

    public static DeviceBuffer For(int quads)
    {
        if (buffer is null || capacity < quads)
        {
            buffer?.Release();
            capacity = Math.Max(1024, (int)System.Numerics.BitOperations.RoundUpToPowerOf2((uint)quads));
            var indices = new int[capacity * 6];
            for (int q = 0; q < capacity; q++)
            {
                ReadOnlySpan<int> corners = [0, 1, 2, 0, 2, 3];
                for (int i = 0; i < 6; i++)
                {
                    indices[(q * 6) + i] = (q * 4) + corners[i];
                }
            }

            buffer = new DeviceBuffer("Quad index buffer", indices.Length, 4, BufferUse.Index);
            GraphicsDevice.Recorder.UpdateBuffer(buffer.Gpu, 0, MemoryMarshal.AsBytes(indices.AsSpan()));
        }

        return buffer;
    }

    public static void Reset() => (buffer, capacity) = (null, 0);
}
