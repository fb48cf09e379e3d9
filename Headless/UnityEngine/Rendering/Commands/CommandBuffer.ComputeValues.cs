using System.Linq;
using System.Runtime.InteropServices;
using System;
using Headless.Engine;

namespace UnityEngine.Rendering;

public partial class CommandBuffer
{
    public void SetComputeFloatParam(ComputeShader computeShader, string name, float val) =>
        SetComputeFloatParam(computeShader, ShaderNames.Id(name), val);

    public void SetComputeFloatParam(ComputeShader computeShader, int nameID, float val) =>
        Value(computeShader, nameID, new Vector4(val, 0f, 0f, 0f), 4);

    public void SetComputeIntParam(ComputeShader computeShader, string name, int val) =>
        SetComputeIntParam(computeShader, ShaderNames.Id(name), val);

    public void SetComputeIntParam(ComputeShader computeShader, int nameID, int val) =>
        Value(computeShader, nameID, new Vector4(BitConverter.Int32BitsToSingle(val), 0f, 0f, 0f), 4);

    public void SetComputeVectorParam(ComputeShader computeShader, string name, Vector4 val) =>
        SetComputeVectorParam(computeShader, ShaderNames.Id(name), val);

    public void SetComputeVectorParam(ComputeShader computeShader, int nameID, Vector4 val) =>
        Value(computeShader, nameID, val, 16);

    public void SetComputeMatrixParam(ComputeShader computeShader, string name, Matrix4x4 val) =>
        SetComputeMatrixParam(computeShader, ShaderNames.Id(name), val);

    public void SetComputeMatrixParam(ComputeShader computeShader, int nameID, Matrix4x4 val) =>
        Bytes(computeShader, nameID, new ReadOnlySpan<Matrix4x4>(in val));

    public void SetComputeFloatParams(ComputeShader computeShader, string name, params float[] values) =>
        SetComputeFloatParams(computeShader, ShaderNames.Id(name), values);

    public void SetComputeFloatParams(ComputeShader computeShader, int nameID, params float[] values) =>
        Bytes<float>(computeShader, nameID, values);

    public void SetComputeIntParams(ComputeShader computeShader, string name, params int[] values) =>
        SetComputeIntParams(computeShader, ShaderNames.Id(name), values);

    public void SetComputeIntParams(ComputeShader computeShader, int nameID, params int[] values) =>
        Bytes<int>(computeShader, nameID, values);

    public void SetComputeVectorArrayParam(ComputeShader computeShader, string name, Vector4[] values) =>
        SetComputeVectorArrayParam(computeShader, ShaderNames.Id(name), values);

    public void SetComputeVectorArrayParam(ComputeShader computeShader, int nameID, Vector4[] values) =>
        Bytes<Vector4>(computeShader, nameID, values);

    public void SetComputeMatrixArrayParam(ComputeShader computeShader, string name, Matrix4x4[] values) =>
        SetComputeMatrixArrayParam(computeShader, ShaderNames.Id(name), values);

    public void SetComputeMatrixArrayParam(ComputeShader computeShader, int nameID, Matrix4x4[] values) =>
        Bytes<Matrix4x4>(computeShader, nameID, values);

    private static T Require<T>(T shader)
        where T : class => shader ?? throw new ArgumentNullException(nameof(shader));

    private void Value(ComputeShader shader, int nameId, Vector4 words, int length) =>
        Add(new SetComputeValueCommand(Require(shader), nameId, words, length));

    private void Bytes<T>(ComputeShader shader, int nameId, ReadOnlySpan<T> values)
        where T : unmanaged => Add(new SetComputeBytesCommand(Require(shader), nameId, MemoryMarshal.AsBytes(values).ToArray()));
}
