using System.Linq;
using System;
using Headless.Vulkan;
using Unity.Collections;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>One read-back: asked for, under way, done or failed.</summary>
internal sealed class ReadbackState
{
    private const int KeptFrames = 2;
    private readonly Action<AsyncGPUReadbackRequest>? callback;
    private ReadbackTicket? ticket;
    private NativeArray<byte> data;
    private Action<ReadOnlyMemory<byte>>? sink;
    private int frames, age;

    public ReadbackState(Action<AsyncGPUReadbackRequest>? callback, Action<ReadOnlyMemory<byte>>? sink = null)
    {
        this.callback = callback;
        this.sink = sink;
    }

    public bool Done { get; private set; }
    public bool HasError { get; private set; }
    public int Width { get; set; }
    public int Height { get; set; } = 1;
    public int Depth { get; set; } = 1;
    public int Size { get; set; }

    /// <summary>True once the data's time is over and the state can be forgotten.</summary>
    public bool Expired => Done && age >= KeptFrames;

    public void Start(ReadbackTicket started) => ticket = started;

    public void Fail()
    {
        (Done, HasError) = (true, true);
        Notify();
    }

    public void Poll()
    {
        if (!Done && frames >= AsyncReadbacks.Frames && ticket is { IsDone: true })
        {
            Complete(ticket.Data);
        }
    }

    public void Wait()
    {
        if (!Done && ticket is not null)
        {
            Complete(ticket.Wait());
        }
    }

    public void Age()
    {
        frames++;
        if (Done && ++age == KeptFrames && data.IsCreated)
        {
            data.Dispose();
        }
    }

    public NativeArray<T> Data<T>()
        where T : struct
    {
        if (!Done)
        {
            throw new InvalidOperationException("Cannot access the data as it is not available: wait until the request is done, or call WaitForCompletion.");
        }

        if (HasError || !data.IsCreated)
        {
            throw new InvalidOperationException("Cannot access the data as it is not available: the request failed, or its frame is over.");
        }

        return data.Reinterpret<T>(1);
    }

    private void Complete(ReadOnlySpan<byte> bytes)
    {
        Done = true;
        if (sink is not null)
        {
            sink(bytes.ToArray());
            sink = null;
        }

        data = new NativeArray<byte>(bytes.Length, Allocator.Persistent);
        bytes.CopyTo(NativeSpans.Write(data));
        Size = bytes.Length;
        Notify();
    }

    private void Notify()
    {
        try
        {
            callback?.Invoke(new AsyncGPUReadbackRequest(this));
        }
        catch (Exception exception)
        {
            UnityEngine.Debug.LogException(exception);
        }
    }
}
