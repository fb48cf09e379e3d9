using System;
using Headless.Engine;
using Unity.Collections;

namespace UnityEngine.Rendering;

public static class AsyncGPUReadback
{
    public static void WaitAllRequests() => AsyncReadbacks.WaitAll();

    public static AsyncGPUReadbackRequest Request(ComputeBuffer src, Action<AsyncGPUReadbackRequest>? callback = null) =>
        OfBuffer(src?.Storage, null, 0, callback);

    public static AsyncGPUReadbackRequest Request(ComputeBuffer src, int size, int offset, Action<AsyncGPUReadbackRequest>? callback = null) =>
        OfBuffer(src?.Storage, size, offset, callback);

    public static AsyncGPUReadbackRequest Request(GraphicsBuffer src, Action<AsyncGPUReadbackRequest>? callback = null) =>
        OfBuffer(src?.Storage, null, 0, callback);

    public static AsyncGPUReadbackRequest Request(GraphicsBuffer src, int size, int offset, Action<AsyncGPUReadbackRequest>? callback = null) =>
        OfBuffer(src?.Storage, size, offset, callback);

    public static AsyncGPUReadbackRequest Request(Texture src, int mipIndex = 0, Action<AsyncGPUReadbackRequest>? callback = null)
    {
        var state = new ReadbackState(callback);
        AsyncReadbacks.StartTexture(state, src, mipIndex);
        return new AsyncGPUReadbackRequest(state);
    }

    public static AsyncGPUReadbackRequest Request(Texture src, int mipIndex, TextureFormat dstFormat, Action<AsyncGPUReadbackRequest>? callback = null)
    {
        if (src != null && src.DeviceTexture(RenderTextureSubElement.Default) is { } gpu && TextureReader.Layout(gpu.Description.Format) != dstFormat)
        {
            throw new NotSupportedException($"AsyncGPUReadback: texture '{src.name}' is {TextureReader.Layout(gpu.Description.Format)}; it can't be read as {dstFormat} on this device.");
        }

        return Request(src!, mipIndex, callback);
    }

    public static AsyncGPUReadbackRequest RequestIntoNativeArray<T>(
        ref NativeArray<T> output, GraphicsBuffer src, Action<AsyncGPUReadbackRequest>? callback = null)
        where T : struct => Into(output, src?.Storage, null, 0, callback);

    public static AsyncGPUReadbackRequest RequestIntoNativeArray<T>(
        ref NativeArray<T> output, GraphicsBuffer src, int size, int offset, Action<AsyncGPUReadbackRequest>? callback = null)
        where T : struct => Into(output, src?.Storage, size, offset, callback);

    public static AsyncGPUReadbackRequest RequestIntoNativeArray<T>(
        ref NativeArray<T> output, ComputeBuffer src, Action<AsyncGPUReadbackRequest>? callback = null)
        where T : struct => Into(output, src?.Storage, null, 0, callback);

    internal static Action<ReadOnlyMemory<byte>> Sink<T>(NativeArray<T> output)
        where T : struct => bytes =>
        {
            if (output.IsCreated)
            {
                Span<byte> target = NativeSpans.WriteBytes(output);
                bytes.Span[..Math.Min(bytes.Length, target.Length)].CopyTo(target);
            }
        };

    private static AsyncGPUReadbackRequest OfBuffer(DeviceBuffer? buffer, int? size, int offset, Action<AsyncGPUReadbackRequest>? callback)
    {
        var state = new ReadbackState(callback);
        AsyncReadbacks.StartBuffer(state, buffer, size ?? (int)(buffer?.ByteSize ?? 0), offset);
        return new AsyncGPUReadbackRequest(state);
    }

    private static AsyncGPUReadbackRequest Into<T>(
        NativeArray<T> output, DeviceBuffer? buffer, int? size, int offset, Action<AsyncGPUReadbackRequest>? callback)
        where T : struct
    {
        int bytes = size ?? (int)(buffer?.ByteSize ?? 0);
        if (bytes > (long)output.Length * NativeSpans.SizeOf<T>())
        {
            throw new ArgumentException($"AsyncGPUReadback: {bytes} bytes do not fit the native array of {(long)output.Length * NativeSpans.SizeOf<T>()} bytes.");
        }

        var state = new ReadbackState(callback, Sink(output));
        AsyncReadbacks.StartBuffer(state, buffer, bytes, offset);
        return new AsyncGPUReadbackRequest(state);
    }
}
