using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;
using System;
using Headless.Engine;
using Unity.Collections;

namespace UnityEngine.Rendering;

public partial class CommandBuffer
{
    public void CopyBuffer(GraphicsBuffer source, GraphicsBuffer dest)
    {
        DeviceBuffer from = Require(source).Storage;
        DeviceBuffer to = Require(dest).Storage;
        if (from.ByteSize != to.ByteSize)
        {
            throw new ArgumentException($"CopyBuffer: '{from.Name}' has {from.ByteSize} bytes and '{to.Name}' {to.ByteSize}; both must be of the same size.");
        }

        if ((source.target & GraphicsBuffer.Target.CopySource) == 0 || (dest.target & GraphicsBuffer.Target.CopyDestination) == 0)
        {
            throw new ArgumentException(
                $"CopyBuffer: '{from.Name}' must be created with GraphicsBuffer.Target.CopySource and '{to.Name}' with Target.CopyDestination.");
        }

        Add(_ => GraphicsDevice.Recorder.CopyBuffer(from.Gpu, 0, to.Gpu, 0, from.ByteSize));
    }

    public void RequestAsyncReadback(Texture src, Action<AsyncGPUReadbackRequest> callback) => RequestAsyncReadback(src, 0, callback);

    public void RequestAsyncReadback(Texture src, int mipIndex, Action<AsyncGPUReadbackRequest> callback) =>
        Add(_ => AsyncReadbacks.StartTexture(new ReadbackState(callback), src, mipIndex));

    public void WaitAllAsyncReadbackRequests() => Add(_ => AsyncReadbacks.WaitAll());

    public void SetBufferData(GraphicsBuffer buffer, Array data) => SetBufferData(buffer, data, 0, 0, data.Length);

    public void SetBufferData(GraphicsBuffer buffer, Array data, int managedBufferStartIndex, int graphicsBufferStartIndex, int count)
    {
        ArrayBytes.RequireBlittable(data, "CommandBuffer.SetBufferData(array)");
        DeviceBuffer.CheckIndices(data.Length, managedBufferStartIndex, graphicsBufferStartIndex, count, "graphicsBufferStartIndex");
        Upload(Require(buffer).Storage, ArrayBytes.Of(data, managedBufferStartIndex, count), ArrayBytes.ElementSize(data), graphicsBufferStartIndex);
    }

    public void SetBufferData<T>(GraphicsBuffer buffer, List<T> data)
        where T : struct => SetBufferData(buffer, data, 0, 0, data.Count);

    public void SetBufferData<T>(GraphicsBuffer buffer, List<T> data, int managedBufferStartIndex, int graphicsBufferStartIndex, int count)
        where T : struct
    {
        DeviceBuffer.CheckIndices(data.Count, managedBufferStartIndex, graphicsBufferStartIndex, count, "graphicsBufferStartIndex");
        ReadOnlySpan<T> part = CollectionsMarshal.AsSpan(data).Slice(managedBufferStartIndex, count);
        Upload(Require(buffer).Storage, NativeSpans.BytesOf(part), NativeSpans.SizeOf<T>(), graphicsBufferStartIndex);
    }

    public void SetBufferData<T>(GraphicsBuffer buffer, NativeArray<T> data)
        where T : struct => SetBufferData(buffer, data, 0, 0, data.Length);

    public void SetBufferData<T>(GraphicsBuffer buffer, NativeArray<T> data, int nativeBufferStartIndex, int graphicsBufferStartIndex, int count)
        where T : struct
    {
        DeviceBuffer.CheckIndices(data.Length, nativeBufferStartIndex, graphicsBufferStartIndex, count, "graphicsBufferStartIndex");
        ReadOnlySpan<T> part = NativeSpans.Read(data).Slice(nativeBufferStartIndex, count);
        Upload(Require(buffer).Storage, NativeSpans.BytesOf(part), NativeSpans.SizeOf<T>(), graphicsBufferStartIndex);
    }

    public void RequestAsyncReadback(GraphicsBuffer src, Action<AsyncGPUReadbackRequest> callback) =>
        RequestAsyncReadback(src, Require(src).count * src.stride, 0, callback);

    public void RequestAsyncReadback(GraphicsBuffer src, int size, int offset, Action<AsyncGPUReadbackRequest> callback)
    {
        DeviceBuffer storage = Require(src).Storage;
        Add(_ => AsyncReadbacks.StartBuffer(new ReadbackState(callback), storage, size, offset));
    }

    public void RequestAsyncReadbackIntoNativeArray<T>(ref NativeArray<T> output, GraphicsBuffer src, Action<AsyncGPUReadbackRequest> callback)
        where T : struct
    {
        DeviceBuffer storage = Require(src).Storage;
        NativeArray<T> target = output;
        Add(_ => AsyncReadbacks.StartBuffer(
            new ReadbackState(callback, AsyncGPUReadback.Sink(target)), storage, (int)storage.ByteSize, 0));
    }

    public void SetBufferData(ComputeBuffer buffer, Array data) => SetBufferData(buffer, data, 0, 0, data.Length);

    public void SetBufferData(ComputeBuffer buffer, Array data, int managedBufferStartIndex, int graphicsBufferStartIndex, int count)
    {
        ArrayBytes.RequireBlittable(data, "CommandBuffer.SetBufferData(array)");
        DeviceBuffer.CheckIndices(data.Length, managedBufferStartIndex, graphicsBufferStartIndex, count, "graphicsBufferStartIndex");
        Upload(Require(buffer).Storage, ArrayBytes.Of(data, managedBufferStartIndex, count), ArrayBytes.ElementSize(data), graphicsBufferStartIndex);
    }

    public void SetBufferData<T>(ComputeBuffer buffer, List<T> data)
        where T : struct => SetBufferData(buffer, data, 0, 0, data.Count);

    public void SetBufferData<T>(ComputeBuffer buffer, List<T> data, int managedBufferStartIndex, int graphicsBufferStartIndex, int count)
        where T : struct
    {
        DeviceBuffer.CheckIndices(data.Count, managedBufferStartIndex, graphicsBufferStartIndex, count, "graphicsBufferStartIndex");
        ReadOnlySpan<T> part = CollectionsMarshal.AsSpan(data).Slice(managedBufferStartIndex, count);
        Upload(Require(buffer).Storage, NativeSpans.BytesOf(part), NativeSpans.SizeOf<T>(), graphicsBufferStartIndex);
    }

    public void SetBufferData<T>(ComputeBuffer buffer, NativeArray<T> data)
        where T : struct => SetBufferData(buffer, data, 0, 0, data.Length);

    public void SetBufferData<T>(ComputeBuffer buffer, NativeArray<T> data, int nativeBufferStartIndex, int graphicsBufferStartIndex, int count)
        where T : struct
    {
        DeviceBuffer.CheckIndices(data.Length, nativeBufferStartIndex, graphicsBufferStartIndex, count, "graphicsBufferStartIndex");
        ReadOnlySpan<T> part = NativeSpans.Read(data).Slice(nativeBufferStartIndex, count);
        Upload(Require(buffer).Storage, NativeSpans.BytesOf(part), NativeSpans.SizeOf<T>(), graphicsBufferStartIndex);
    }

    public void RequestAsyncReadback(ComputeBuffer src, Action<AsyncGPUReadbackRequest> callback) =>
        RequestAsyncReadback(src, Require(src).count * src.stride, 0, callback);

    public void RequestAsyncReadback(ComputeBuffer src, int size, int offset, Action<AsyncGPUReadbackRequest> callback)
    {
        DeviceBuffer storage = Require(src).Storage;
        Add(_ => AsyncReadbacks.StartBuffer(new ReadbackState(callback), storage, size, offset));
    }

    public void RequestAsyncReadbackIntoNativeArray<T>(ref NativeArray<T> output, ComputeBuffer src, Action<AsyncGPUReadbackRequest> callback)
        where T : struct
    {
        DeviceBuffer storage = Require(src).Storage;
        NativeArray<T> target = output;
        Add(_ => AsyncReadbacks.StartBuffer(
            new ReadbackState(callback, AsyncGPUReadback.Sink(target)), storage, (int)storage.ByteSize, 0));
    }

    private void Upload(DeviceBuffer buffer, ReadOnlySpan<byte> data, int elementSize, int first)
    {
        long offset = buffer.CheckRange(data.Length, elementSize, first, nameof(SetBufferData));
        if (data.IsEmpty)
        {
            return;
        }

        byte[] copy = data.ToArray();
        Add(_ => GraphicsDevice.Recorder.UpdateBuffer(buffer.Gpu, offset, copy));
    }
}
