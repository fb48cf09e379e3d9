using System.Collections.Generic;
using System.Linq;
using Headless.Vulkan;
using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>All read-backs that are under way or whose data is still valid.</summary>
internal static class AsyncReadbacks
{
    private static readonly List<ReadbackState> States = [];

    /// <summary>
    /// Frames until one arrives, at least: 1 is the frame after the request's. In Unity the device works some frames behind, so it is often 2 or 3.
    /// </summary>
    public static int Frames { get; set; } = 1;

    public static void StartBuffer(ReadbackState state, DeviceBuffer? buffer, int size, int offset)
    {
        States.Add(state);
        if (buffer is not { IsValid: true } || offset < 0 || size <= 0 || offset + (long)size > buffer.ByteSize)
        {
            Debug.LogError(buffer is { IsValid: true }
                ? $"AsyncGPUReadback: bytes {offset} to {offset + (long)size} are not in buffer '{buffer.Name}' of {buffer.ByteSize} bytes."
                : "AsyncGPUReadback: the source buffer is null or has been released.");
            state.Fail();
            return;
        }

        state.Width = size;
        state.Start(GraphicsDevice.Device.RequestRead(buffer.Gpu, offset, size));
    }

    public static void StartTexture(ReadbackState state, Texture? texture, int mip)
    {
        States.Add(state);
        GpuTexture? gpu = texture == null ? null : texture.DeviceTexture(RenderTextureSubElement.Default);
        if (gpu is null || mip < 0 || mip >= gpu.Description.MipLevels)
        {
            Debug.LogError(gpu is null
                ? "AsyncGPUReadback: the source texture is null or has been destroyed."
                : $"AsyncGPUReadback: texture '{texture!.name}' has {gpu.Description.MipLevels} mip levels; there is no level {mip}.");
            state.Fail();
            return;
        }

        (state.Width, state.Height, state.Depth) = gpu.MipSize(mip);
        state.Start(GraphicsDevice.Device.RequestRead(gpu, mip));
    }

    /// <summary>Once a frame: finishes what has arrived and forgets what is over.</summary>
    public static void Update()
    {
        foreach (ReadbackState state in States.ToArray())
        {
            state.Age();
            state.Poll();
        }

        States.RemoveAll(s => s.Expired);
    }

    public static void WaitAll()
    {
        foreach (ReadbackState state in States.ToArray())
        {
            state.Wait();
        }
    }

    public static void Reset() => States.Clear();
}
