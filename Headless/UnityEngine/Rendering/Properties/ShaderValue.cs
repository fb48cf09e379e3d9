using System.Linq;
using System.Runtime.InteropServices;
using System;
using UnityEngine;

namespace Headless.Engine;

/// <summary>A number, vector, matrix or array set by name on a material, a property block or globally.</summary>
internal sealed class ShaderValue
{
    private float[] floats = new float[4];

    public ShaderValueKind Kind { get; private set; }
    public int Integer { get; private set; }
    public int FloatCount { get; private set; }
    public ReadOnlySpan<float> Floats => floats.AsSpan(0, FloatCount);
    public float X => Kind == ShaderValueKind.Integer ? Integer : floats[0];
    public Vector4 Vector => new(floats[0], floats[1], floats[2], floats[3]);

    public Matrix4x4 Matrix => MemoryMarshal.Cast<float, Matrix4x4>(Floats)[0];

    public void Set(float value) => Set(ShaderValueKind.Float, new ReadOnlySpan<float>(in value));

    public void Set(int value)
    {
        Set(ShaderValueKind.Integer, [value]);
        Integer = value;
    }

    public void Set(Vector4 value, ShaderValueKind kind) =>
        Set(kind, MemoryMarshal.Cast<Vector4, float>(new ReadOnlySpan<Vector4>(in value)));

    public void Set(in Matrix4x4 value) =>
        Set(ShaderValueKind.Matrix, MemoryMarshal.Cast<Matrix4x4, float>(new ReadOnlySpan<Matrix4x4>(in value)));

    public void Set(ShaderValueKind kind, ReadOnlySpan<float> values)
    {
        Kind = kind;
        FloatCount = values.Length;
        if (floats.Length < values.Length)
        {
            floats = new float[values.Length];
        }

        values.CopyTo(floats);
    }

    public T[] ToArray<T>()
        where T : unmanaged => MemoryMarshal.Cast<float, T>(Floats).ToArray();

    public ShaderValue Clone()
    {
        var copy = new ShaderValue { Integer = Integer };
        copy.Set(Kind, Floats);
        copy.Integer = Integer;
        return copy;
    }
}
