using System.Collections.Generic;
using System.Runtime.InteropServices;
using Headless.Engine;

namespace UnityEngine;

public sealed partial class MaterialPropertyBlock
{
    public void SetFloat(string name, float value) => SetFloat(ShaderNames.Id(name), value);

    public void SetFloat(int nameID, float value) => Sheet.SetFloat(nameID, value);

    public void SetInt(string name, int value) => SetInt(ShaderNames.Id(name), value);

    public void SetInt(int nameID, int value) => Sheet.SetFloat(nameID, value);

    public void SetInteger(string name, int value) => SetInteger(ShaderNames.Id(name), value);

    public void SetInteger(int nameID, int value) => Sheet.SetInteger(nameID, value);

    public void SetVector(string name, Vector4 value) => SetVector(ShaderNames.Id(name), value);

    public void SetVector(int nameID, Vector4 value) => Sheet.SetVector(nameID, value);

    public void SetColor(string name, Color value) => SetColor(ShaderNames.Id(name), value);

    public void SetColor(int nameID, Color value) => Sheet.SetColor(nameID, value);

    public void SetMatrix(string name, Matrix4x4 value) => SetMatrix(ShaderNames.Id(name), value);

    public void SetMatrix(int nameID, Matrix4x4 value) => Sheet.SetMatrix(nameID, value);

    public void SetFloatArray(string name, float[] values) => SetFloatArray(ShaderNames.Id(name), values);

    public void SetFloatArray(int nameID, float[] values) => Sheet.SetFloats(nameID, values);

    public void SetFloatArray(string name, List<float> values) => SetFloatArray(ShaderNames.Id(name), values);

    public void SetFloatArray(int nameID, List<float> values) => Sheet.SetFloats(nameID, CollectionsMarshal.AsSpan(values));

    public void SetVectorArray(string name, Vector4[] values) => SetVectorArray(ShaderNames.Id(name), values);

    public void SetVectorArray(int nameID, Vector4[] values) => Sheet.SetVectors(nameID, values);

    public void SetVectorArray(string name, List<Vector4> values) => SetVectorArray(ShaderNames.Id(name), values);

    public void SetVectorArray(int nameID, List<Vector4> values) => Sheet.SetVectors(nameID, CollectionsMarshal.AsSpan(values));

    public void SetMatrixArray(string name, Matrix4x4[] values) => SetMatrixArray(ShaderNames.Id(name), values);

    public void SetMatrixArray(int nameID, Matrix4x4[] values) => Sheet.SetMatrices(nameID, values);

    public void SetMatrixArray(string name, List<Matrix4x4> values) => SetMatrixArray(ShaderNames.Id(name), values);

    public void SetMatrixArray(int nameID, List<Matrix4x4> values) => Sheet.SetMatrices(nameID, CollectionsMarshal.AsSpan(values));
}
