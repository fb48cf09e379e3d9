using System;
using Headless.Vulkan;
using UnityEngine;

namespace Headless.Engine;

/// <summary>The GPU side of a GraphicsBuffer or ComputeBuffer, with Unity's checks on what goes in and out.</summary>
internal sealed class DeviceBuffer
{
    private readonly string kind;
    private GpuBuffer? gpu;
    private string name;

    /// <param name="counts">The buffer has a hidden counter, which begins at 0.</param>
    public DeviceBuffer(string kind, int count, int stride, BufferUse use, bool counts = false)
    {
        if (count <= 0)
        {
            throw new ArgumentException($"Attempting to create a zero length {kind}", nameof(count));
        }

        if (stride <= 0)
        {
            throw new ArgumentException($"Attempting to create a {kind} with a negative or null stride", nameof(stride));
        }

        this.kind = kind;
        name = kind;
        Count = count;
        Stride = stride;
        ByteSize = (long)count * stride;
        long limit = SystemInfo.maxGraphicsBufferSize;
        if (ByteSize > limit)
        {
            throw new ArgumentException(
                $"The total size of the {kind} ({ByteSize} bytes: {count} elements of {stride} bytes) exceeds the maximum buffer size ({limit}). Maximum supported buffer size: {limit} bytes.");
        }

        // Copies and fills are made in whole words.
        gpu = GraphicsDevice.Device.CreateBuffer((ByteSize + 3) & ~3L, use, kind);
        Counter = counts ? BufferCounter.Create(kind, 0) : null;
    }

    public int Count { get; }
    public int Stride { get; }
    public long ByteSize { get; }
    /// <summary>The hidden counter of append, consume and counted buffers; null for others, and once released.</summary>
    public GpuBuffer? Counter { get; private set; }

    public bool IsValid => gpu is not null;

    /// <summary>What a script created it for; nothing for buffers of the engine's own.</summary>
    public BufferTargets Targets { get; set; }

    public string Name
    {
        get => name;
        set => name = value;
    }

    /// <summary>The live buffer; an error that names the buffer once it is released.</summary>
    public GpuBuffer Gpu => gpu ?? throw new NullReferenceException($"{kind} '{name}' has been released and cannot be used any more.");

    /// <summary>The live buffer, or null once released.</summary>
    public GpuBuffer? GpuOrNull => gpu;

    public void Release()
    {
        gpu?.Dispose();
        Counter?.Dispose();
        (gpu, Counter) = (null, null);
    }

    /// <summary>Gives the memory back from the finalizer, where nothing but queuing is safe.</summary>
    public void Abandon()
    {
        if (gpu is { } left)
        {
            gpu = null;
            GraphicsDevice.ReportLeak(kind, name, left);
            if (Counter is { } counter)
            {
                Counter = null;
                GraphicsDevice.FreeLater(counter);
            }
        }
    }

    public void Upload(ReadOnlySpan<byte> data, int elementSize, long firstElement, string method)
    {
        long offset = CheckRange(data.Length, elementSize, firstElement, method);
        if (!data.IsEmpty)
        {
            GraphicsDevice.Recorder.UpdateBuffer(Gpu, offset, data);
        }
    }

    public void Download(Span<byte> data, int elementSize, long firstElement, string method)
    {
        long offset = CheckRange(data.Length, elementSize, firstElement, method);
        if (!data.IsEmpty)
        {
            GraphicsDevice.Device.ReadBuffer(Gpu, offset, data);
        }
    }

    public long CheckRange(int bytes, int elementSize, long firstElement, string method)
    {
        _ = Gpu;
        if (Stride % elementSize != 0 && elementSize % Stride != 0)
        {
            throw new ArgumentException(
                $"{kind}.{method}(): one of C# data stride ({elementSize} bytes) and buffer stride ({Stride} bytes) should be multiple of other ('{name}').");
        }

        long offset = firstElement * elementSize;
        if (offset + bytes > ByteSize)
        {
            throw new ArgumentException(
                $"{kind}.{method}(): accessing {bytes} bytes at offset {offset} for {kind} '{name}' of size {ByteSize} bytes is not possible.");
        }

        return offset;
    }

    public static void CheckIndices(int length, int managedStart, int bufferStart, int count, string bufferIndexName)
    {
        if (managedStart < 0 || bufferStart < 0 || count < 0 || managedStart + (long)count > length)
        {
            throw new ArgumentOutOfRangeException(
                null, $"Bad indices/count arguments (managedBufferStartIndex:{managedStart} {bufferIndexName}:{bufferStart} count:{count})");
        }
    }
}
