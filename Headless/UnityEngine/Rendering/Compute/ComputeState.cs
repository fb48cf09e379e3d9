using System.Collections.Generic;
using System;

namespace Headless.Engine;

/// <summary>Values and constant buffers of a compute shader, shared by all its kernels as in Unity.</summary>
internal sealed class ComputeState
{
    private readonly Dictionary<int, ComputeValue> values = [];

    /// <summary>Grows with every change of a value.</summary>
    public int Version { get; private set; }

    public Dictionary<int, BufferSlot> ConstantBuffers { get; } = [];

    /// <summary>The slot of a name; made on first use, so that variants can hold on to it.</summary>
    public ComputeValue Value(int id)
    {
        if (!values.TryGetValue(id, out ComputeValue? value))
        {
            value = new ComputeValue();
            values.Add(id, value);
        }

        return value;
    }

    public void Set(int id, ReadOnlySpan<byte> bytes)
    {
        if (Value(id).Set(bytes))
        {
            Version++;
        }
    }

    public void CopyFrom(ComputeState other)
    {
        foreach ((int id, ComputeValue value) in other.values)
        {
            Value(id).CopyFrom(value);
        }

        foreach ((int id, BufferSlot slot) in other.ConstantBuffers)
        {
            ConstantBuffers[id] = slot;
        }

        Version++;
    }
}
