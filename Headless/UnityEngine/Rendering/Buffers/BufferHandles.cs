using System.Collections.Concurrent;
using System;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Buffers by the number in their GraphicsBufferHandle.</summary>
internal static class BufferHandles
{
    private static readonly ConcurrentDictionary<uint, WeakReference<DeviceBuffer>> Buffers = new();

    public static void Add(uint handle, DeviceBuffer buffer) => Buffers[handle] = new WeakReference<DeviceBuffer>(buffer);

    public static void Remove(uint handle) => Buffers.TryRemove(handle, out _);

    public static DeviceBuffer? Find(GraphicsBufferHandle handle) =>
        Buffers.TryGetValue(handle.value, out WeakReference<DeviceBuffer>? reference) && reference.TryGetTarget(out DeviceBuffer? buffer)
            ? buffer
            : null;

    public static GraphicsBufferHandle HandleOf(DeviceBuffer? buffer)
    {
        foreach ((uint handle, WeakReference<DeviceBuffer> reference) in Buffers)
        {
            if (buffer is not null && reference.TryGetTarget(out DeviceBuffer? candidate) && candidate == buffer)
            {
                return new GraphicsBufferHandle(handle);
            }
        }

        return default;
    }
}
