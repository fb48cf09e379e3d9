using System.Runtime.InteropServices;
using System;
using Headless.Engine;

namespace UnityEngine;

public sealed partial class ComputeShader
{
    public void SetFloat(string name, float val) => SetFloat(ShaderNames.Id(name), val);

    public void SetFloat(int nameID, float val) => SetBytes(nameID, new ReadOnlySpan<float>(in val));

    public void SetInt(string name, int val) => SetInt(ShaderNames.Id(name), val);

    public void SetInt(int nameID, int val) => SetBytes(nameID, new ReadOnlySpan<int>(in val));

    public void SetBool(string name, bool val) => SetInt(ShaderNames.Id(name), val ? 1 : 0);

    public void SetBool(int nameID, bool val) => SetInt(nameID, val ? 1 : 0);

    public void SetVector(string name, Vector4 val) => SetVector(ShaderNames.Id(name), val);

    public void SetVector(int nameID, Vector4 val) => SetBytes(nameID, new ReadOnlySpan<Vector4>(in val));

    public void SetMatrix(string name, Matrix4x4 val) => SetMatrix(ShaderNames.Id(name), val);

    public void SetMatrix(int nameID, Matrix4x4 val) => SetBytes(nameID, new ReadOnlySpan<Matrix4x4>(in val));

    public void SetFloats(string name, params float[] values) => SetFloats(ShaderNames.Id(name), values);

    public void SetFloats(int nameID, params float[] values) => SetBytes<float>(nameID, values);

    public void SetInts(string name, params int[] values) => SetInts(ShaderNames.Id(name), values);

    public void SetInts(int nameID, params int[] values) => SetBytes<int>(nameID, values);

    public void SetVectorArray(string name, Vector4[] values) => SetVectorArray(ShaderNames.Id(name), values);

    public void SetVectorArray(int nameID, Vector4[] values) => SetBytes<Vector4>(nameID, values);

    public void SetMatrixArray(string name, Matrix4x4[] values) => SetMatrixArray(ShaderNames.Id(name), values);

    public void SetMatrixArray(int nameID, Matrix4x4[] values) => SetBytes<Matrix4x4>(nameID, values);

    internal void SetBytes<T>(int nameID, ReadOnlySpan<T> values)
        where T : unmanaged => Program.State.Set(nameID, MemoryMarshal.AsBytes(values));
}
