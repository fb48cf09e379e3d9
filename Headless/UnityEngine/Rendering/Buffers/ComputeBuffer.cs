using System;
using Headless.Engine;
using Headless.Vulkan;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Collections;

namespace UnityEngine;

public sealed partial class ComputeBuffer : IDisposable
{
    private readonly ComputeBufferMode mode;
    private NativeArray<byte> writing;
    private long writingOffset;

    public ComputeBuffer(int count, int stride)
        : this(count, stride, ComputeBufferType.Default, ComputeBufferMode.Immutable)
    {
    }

    public ComputeBuffer(int count, int stride, ComputeBufferType type)
        : this(count, stride, type, ComputeBufferMode.Immutable)
    {
    }

    public ComputeBuffer(int count, int stride, ComputeBufferType type, ComputeBufferMode usage)
    {
        mode = usage;
        Storage = new DeviceBuffer(
            nameof(ComputeBuffer), count, stride, BufferUse.Storage | BufferUse.Transfer | BufferUse.Indirect | BufferUse.Uniform,
            (type & (ComputeBufferType.Append | ComputeBufferType.Counter)) != 0)
        {
            Targets = BufferTargets.Of(type),
        };
    }

    ~ComputeBuffer()
    {
        Storage?.Abandon();
    }

    public int count => Storage.IsValid ? Storage.Count : 0;
    public int stride => Storage.IsValid ? Storage.Stride : 0;

    public string name
    {
        set => Storage.Name = value;
    }

    internal DeviceBuffer Storage { get; }

    public bool IsValid() => Storage.IsValid;

    public void Release() => Dispose();

    public void Dispose()
    {
        Storage.Release();
        GC.SuppressFinalize(this);
    }

    public NativeArray<T> BeginWrite<T>(int computeBufferStartIndex, int count)
        where T : struct
    {
        if (mode != ComputeBufferMode.SubUpdates)
        {
            throw new InvalidOperationException("ComputeBuffer must be created with usage mode 'SubUpdates' to be able to be mapped with BeginWrite");
        }

        if (writing.IsCreated)
        {
            throw new InvalidOperationException("ComputeBuffer is being written already: call EndWrite first.");
        }

        int size = UnsafeUtility.SizeOf<T>();
        writingOffset = Storage.CheckRange(checked(count * size), size, computeBufferStartIndex, nameof(BeginWrite));
        writing = new NativeArray<byte>(count * size, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
        return writing.Reinterpret<T>(1);
    }

    public void EndWrite<T>(int countWritten)
        where T : struct
    {
        if (!writing.IsCreated)
        {
            throw new InvalidOperationException("ComputeBuffer is not being written: call BeginWrite first.");
        }

        ReadOnlySpan<byte> data = NativeSpans.Read(writing)[..checked(countWritten * UnsafeUtility.SizeOf<T>())];
        if (!data.IsEmpty)
        {
            GraphicsDevice.Recorder.UpdateBuffer(Storage.Gpu, writingOffset, data);
        }

        writing.Dispose();
        writing = default;
    }
}
