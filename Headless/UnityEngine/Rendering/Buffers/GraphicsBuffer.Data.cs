using System.Collections.Generic;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System;
using Headless.Engine;
using Unity.Collections;

namespace UnityEngine;

public sealed partial class GraphicsBuffer
{
    public void SetData(Array data)
    {
        ArgumentNullException.ThrowIfNull(data);
        SetData(data, 0, 0, data.Length);
    }

    public void SetData(Array data, int managedBufferStartIndex, int graphicsBufferStartIndex, int count)
    {
        ArgumentNullException.ThrowIfNull(data);
        ArrayBytes.RequireBlittable(data, "GraphicsBuffer.SetData(array)");
        DeviceBuffer.CheckIndices(data.Length, managedBufferStartIndex, graphicsBufferStartIndex, count, "graphicsBufferStartIndex");
        Storage.Upload(ArrayBytes.Of(data, managedBufferStartIndex, count), ArrayBytes.ElementSize(data), graphicsBufferStartIndex, nameof(SetData));
    }

    public void SetData<T>(List<T> data)
        where T : struct
    {
        ArgumentNullException.ThrowIfNull(data);
        Upload<T>(CollectionsMarshal.AsSpan(data), 0);
    }

    public void SetData<T>(List<T> data, int managedBufferStartIndex, int graphicsBufferStartIndex, int count)
        where T : struct
    {
        ArgumentNullException.ThrowIfNull(data);
        DeviceBuffer.CheckIndices(data.Count, managedBufferStartIndex, graphicsBufferStartIndex, count, "graphicsBufferStartIndex");
        Upload<T>(CollectionsMarshal.AsSpan(data).Slice(managedBufferStartIndex, count), graphicsBufferStartIndex);
    }

    public void SetData<T>(NativeArray<T> data)
        where T : struct => Upload(NativeSpans.Read(data), 0);

    public void SetData<T>(NativeArray<T> data, int nativeBufferStartIndex, int graphicsBufferStartIndex, int count)
        where T : struct
    {
        DeviceBuffer.CheckIndices(data.Length, nativeBufferStartIndex, graphicsBufferStartIndex, count, "graphicsBufferStartIndex");
        Upload(NativeSpans.Read(data).Slice(nativeBufferStartIndex, count), graphicsBufferStartIndex);
    }

    public void GetData(Array data)
    {
        ArgumentNullException.ThrowIfNull(data);
        GetData(data, 0, 0, data.Length);
    }

    public void GetData(Array data, int managedBufferStartIndex, int computeBufferStartIndex, int count)
    {
        ArgumentNullException.ThrowIfNull(data);
        ArrayBytes.RequireBlittable(data, "GraphicsBuffer.GetData(array)");
        DeviceBuffer.CheckIndices(data.Length, managedBufferStartIndex, computeBufferStartIndex, count, "computeBufferStartIndex");
        Storage.Download(ArrayBytes.Of(data, managedBufferStartIndex, count), ArrayBytes.ElementSize(data), computeBufferStartIndex, nameof(GetData));
    }

    private void Upload<T>(ReadOnlySpan<T> data, int first)
        where T : struct
    {
        if (RuntimeHelpers.IsReferenceOrContainsReferences<T>())
        {
            throw new ArgumentException($"Data passed to GraphicsBuffer.SetData must be blittable.\n{typeof(T).Name} holds references.");
        }

        ReadOnlySpan<byte> bytes = MemoryMarshal.CreateReadOnlySpan(
            ref Unsafe.As<T, byte>(ref MemoryMarshal.GetReference(data)), checked(data.Length * Unsafe.SizeOf<T>()));
        Storage.Upload(bytes, Unsafe.SizeOf<T>(), first, nameof(SetData));
    }
}
