using System.Threading;
using System;
using Headless.Engine;
using Headless.Vulkan;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Collections;

namespace UnityEngine;

public sealed partial class GraphicsBuffer : IDisposable
{
    private static uint lastHandle;
    private NativeArray<byte> locked;
    private readonly bool borrowed;
    private long lockedOffset;

    public GraphicsBuffer(Target target, int count, int stride)
        : this(target, UsageFlags.None, count, stride)
    {
    }

    public GraphicsBuffer(Target target, UsageFlags usageFlags, int count, int stride)
    {
        if ((target & Target.Index) != 0 && stride is not (2 or 4))
        {
            throw new ArgumentException($"Attempting to create an index buffer with an invalid stride: {stride}", nameof(stride));
        }

        if ((target & Target.Index) == 0 && stride % 4 != 0)
        {
            throw new ArgumentException($"Stride must be a multiple of 4 unless the buffer is an index buffer: {stride}", nameof(stride));
        }

        if ((target & Target.Structured) != 0 && (target & (Target.Index | Target.Vertex)) != 0)
        {
            throw new ArgumentException(
                $"GraphicsBuffer target {target}: DirectX 11 does not allow Index or Vertex buffers to also be Structured. Use Raw, and (RW)ByteAddressBuffer in shaders.",
                nameof(target));
        }

        if ((usageFlags & UsageFlags.LockBufferForWrite) != 0 && (target & Target.CopyDestination) != 0)
        {
            throw new ArgumentException("GraphicsBuffer with usageFlags LockBufferForWrite can't have target CopyDestination.");
        }

        this.target = target;
        this.usageFlags = usageFlags;
        Storage = new DeviceBuffer(
            nameof(GraphicsBuffer), count, stride, Use(target), (target & (Target.Append | Target.Counter)) != 0)
        {
            Targets = BufferTargets.Of(target),
        };
        Handle = Interlocked.Increment(ref lastHandle);
        BufferHandles.Add(Handle, Storage);
    }

    /// <summary>A view of a buffer that a mesh owns: disposing it leaves the mesh's buffer alive.</summary>
    internal GraphicsBuffer(Target target, DeviceBuffer shared)
    {
        this.target = target;
        Storage = shared;
        shared.Targets = BufferTargets.Of(target);
        borrowed = true;
        Handle = Interlocked.Increment(ref lastHandle);
        BufferHandles.Add(Handle, Storage);
    }

    ~GraphicsBuffer()
    {
        if (!borrowed)
        {
            Storage?.Abandon();
        }
    }

    public Target target { get; }
    public UsageFlags usageFlags { get; }
    public int count => Storage.IsValid ? Storage.Count : 0;
    public int stride => Storage.IsValid ? Storage.Stride : 0;
    public GraphicsBufferHandle bufferHandle => new(Handle);

    public string name
    {
        set => Storage.Name = value;
    }

    internal DeviceBuffer Storage { get; }
    private uint Handle { get; }

    public bool IsValid() => Storage.IsValid;

    public void Release() => Dispose();

    public void Dispose()
    {
        BufferHandles.Remove(Handle);
        if (!borrowed)
        {
            Storage.Release();
        }

        GC.SuppressFinalize(this);
    }

    public NativeArray<T> LockBufferForWrite<T>(int bufferStartIndex, int count)
        where T : struct
    {
        if ((usageFlags & UsageFlags.LockBufferForWrite) == 0)
        {
            throw new InvalidOperationException("GraphicsBuffer must be created with usageFlags LockBufferForWrite to be locked.");
        }

        if (locked.IsCreated)
        {
            throw new InvalidOperationException("GraphicsBuffer is locked already: call UnlockBufferAfterWrite first.");
        }

        int size = UnsafeUtility.SizeOf<T>();
        lockedOffset = Storage.CheckRange(checked(count * size), size, bufferStartIndex, nameof(LockBufferForWrite));
        locked = new NativeArray<byte>(count * size, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
        return locked.Reinterpret<T>(1);
    }

    public void UnlockBufferAfterWrite<T>(int countWritten)
        where T : struct
    {
        if (!locked.IsCreated)
        {
            throw new InvalidOperationException("GraphicsBuffer is not locked: call LockBufferForWrite first.");
        }

        ReadOnlySpan<byte> data = NativeSpans.Read(locked)[..checked(countWritten * UnsafeUtility.SizeOf<T>())];
        if (!data.IsEmpty)
        {
            GraphicsDevice.Recorder.UpdateBuffer(Storage.Gpu, lockedOffset, data);
        }

        locked.Dispose();
        locked = default;
    }

    private static BufferUse Use(Target target)
    {
        BufferUse use = BufferTargets.Of(target).View == BufferView.None ? BufferUse.Transfer : BufferUse.Storage;
        if ((target & Target.IndirectArguments) != 0)
        {
            use |= BufferUse.Indirect;
        }

        if ((target & Target.Vertex) != 0)
        {
            use |= BufferUse.Vertex;
        }

        if ((target & Target.Index) != 0)
        {
            use |= BufferUse.Index;
        }

        if ((target & Target.Constant) != 0)
        {
            use |= BufferUse.Uniform;
        }

        return use;
    }
}
