using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;
using System;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Values, textures and buffers by property number: what a material, a property block or the globals hold.</summary>
internal sealed class PropertySheet
{
    public Dictionary<int, ShaderValue> Values { get; } = [];
    public Dictionary<int, TextureSlot> Textures { get; } = [];
    public Dictionary<int, BufferSlot> Buffers { get; } = [];
    public Dictionary<int, BufferSlot> ConstantBuffers { get; } = [];

    public bool IsEmpty => Values.Count + Textures.Count + Buffers.Count + ConstantBuffers.Count == 0;

    public void Clear()
    {
        Values.Clear();
        Textures.Clear();
        Buffers.Clear();
        ConstantBuffers.Clear();
    }

    public void SetFloat(int id, float value) => Slot(id).Set(value);

    public void SetInteger(int id, int value) => Slot(id).Set(value);

    public void SetVector(int id, Vector4 value) => Slot(id).Set(value, ShaderValueKind.Vector);

    public void SetColor(int id, Color value) => Slot(id).Set(value, ShaderValueKind.Color);

    public void SetMatrix(int id, in Matrix4x4 value) => Slot(id).Set(in value);

    public void SetFloats(int id, ReadOnlySpan<float> values) => SetArray(id, ShaderValueKind.FloatArray, values);

    public void SetVectors(int id, ReadOnlySpan<Vector4> values) =>
        SetArray(id, ShaderValueKind.VectorArray, MemoryMarshal.Cast<Vector4, float>(values));

    public void SetMatrices(int id, ReadOnlySpan<Matrix4x4> values) =>
        SetArray(id, ShaderValueKind.MatrixArray, MemoryMarshal.Cast<Matrix4x4, float>(values));

    public void SetTexture(int id, TextureSlot slot) => Textures[id] = slot;

    public void SetBuffer(int id, DeviceBuffer? buffer) => Buffers[id] = new BufferSlot(buffer);

    public void SetConstantBuffer(int id, BufferSlot slot)
    {
        if (slot.Buffer is null)
        {
            ConstantBuffers.Remove(id);
        }
        else
        {
            ConstantBuffers[id] = slot;
        }
    }

    public float GetFloat(int id) => Values.TryGetValue(id, out ShaderValue? v) ? v.X : 0f;

    public int GetInteger(int id) =>
        Values.TryGetValue(id, out ShaderValue? v) ? v.Kind == ShaderValueKind.Integer ? v.Integer : (int)v.X : 0;

    public Vector4 GetVector(int id) => Values.TryGetValue(id, out ShaderValue? v) ? v.Vector : default;

    public Matrix4x4 GetMatrix(int id) =>
        Values.TryGetValue(id, out ShaderValue? v) && v.FloatCount >= 16 ? v.Matrix : Matrix4x4.identity;

    public T[]? GetArray<T>(int id, ShaderValueKind kind)
        where T : unmanaged =>
        Values.TryGetValue(id, out ShaderValue? v) && v.Kind == kind ? v.ToArray<T>() : null;

    public bool Has(int id, params ReadOnlySpan<ShaderValueKind> kinds) =>
        Values.TryGetValue(id, out ShaderValue? v) && (kinds.Length == 0 || kinds.Contains(v.Kind));

    public bool Has(int id) =>
        Values.ContainsKey(id) || Textures.ContainsKey(id) || Buffers.ContainsKey(id) || ConstantBuffers.ContainsKey(id);

    public void CopyFrom(PropertySheet other)
    {
        foreach ((int id, ShaderValue value) in other.Values)
        {
            Values[id] = value.Clone();
        }

        CopyAll(other.Textures, Textures);
        CopyAll(other.Buffers, Buffers);
        CopyAll(other.ConstantBuffers, ConstantBuffers);
    }

    public PropertySheet Clone()
    {
        var copy = new PropertySheet();
        copy.CopyFrom(this);
        return copy;
    }

    private static void CopyAll<T>(Dictionary<int, T> from, Dictionary<int, T> to)
    {
        foreach ((int id, T value) in from)
        {
            to[id] = value;
        }
    }

    private void SetArray(int id, ShaderValueKind kind, ReadOnlySpan<float> values)
    {
        if (values.IsEmpty)
        {
            throw new ArgumentException("Zero-sized array is not allowed.", nameof(values));
        }

        Slot(id).Set(kind, values);
    }

    private ShaderValue Slot(int id)
    {
        ref ShaderValue? slot = ref CollectionsMarshal.GetValueRefOrAddDefault(Values, id, out _);
        return slot ??= new ShaderValue();
    }
}
