using Headless.Engine;

namespace UnityEngine;

public sealed partial class MaterialPropertyBlock
{
    public float GetFloat(string name) => GetFloat(ShaderNames.Id(name));

    public float GetFloat(int nameID) => Sheet.GetFloat(nameID);

    public int GetInt(string name) => GetInt(ShaderNames.Id(name));

    public int GetInt(int nameID) => (int)Sheet.GetFloat(nameID);

    public int GetInteger(string name) => GetInteger(ShaderNames.Id(name));

    public int GetInteger(int nameID) => Sheet.GetInteger(nameID);

    public Vector4 GetVector(string name) => GetVector(ShaderNames.Id(name));

    public Vector4 GetVector(int nameID) => Sheet.GetVector(nameID);

    public Color GetColor(string name) => GetColor(ShaderNames.Id(name));

    public Color GetColor(int nameID) => Sheet.GetVector(nameID);

    public Matrix4x4 GetMatrix(string name) => GetMatrix(ShaderNames.Id(name));

    public Matrix4x4 GetMatrix(int nameID) => Sheet.GetMatrix(nameID);

    public float[]? GetFloatArray(string name) => GetFloatArray(ShaderNames.Id(name));

    public float[]? GetFloatArray(int nameID) => Sheet.GetArray<float>(nameID, ShaderValueKind.FloatArray);

    public Vector4[]? GetVectorArray(string name) => GetVectorArray(ShaderNames.Id(name));

    public Vector4[]? GetVectorArray(int nameID) => Sheet.GetArray<Vector4>(nameID, ShaderValueKind.VectorArray);

    public Matrix4x4[]? GetMatrixArray(string name) => GetMatrixArray(ShaderNames.Id(name));

    public Matrix4x4[]? GetMatrixArray(int nameID) => Sheet.GetArray<Matrix4x4>(nameID, ShaderValueKind.MatrixArray);

    public bool HasFloat(string name) => HasFloat(ShaderNames.Id(name));

    public bool HasFloat(int nameID) => Sheet.Has(nameID, ShaderValueKind.Float);

    public bool HasInt(string name) => HasInt(ShaderNames.Id(name));

    public bool HasInt(int nameID) => Sheet.Has(nameID, ShaderValueKind.Float);

    public bool HasInteger(string name) => HasInteger(ShaderNames.Id(name));

    public bool HasInteger(int nameID) => Sheet.Has(nameID, ShaderValueKind.Integer);

    public bool HasVector(string name) => HasVector(ShaderNames.Id(name));

    public bool HasVector(int nameID) => Sheet.Has(nameID, ShaderValueKind.Vector, ShaderValueKind.Color);

    public bool HasColor(string name) => HasColor(ShaderNames.Id(name));

    public bool HasColor(int nameID) => Sheet.Has(nameID, ShaderValueKind.Vector, ShaderValueKind.Color);

    public bool HasMatrix(string name) => HasMatrix(ShaderNames.Id(name));

    public bool HasMatrix(int nameID) => Sheet.Has(nameID, ShaderValueKind.Matrix);

    public bool HasBuffer(string name) => HasBuffer(ShaderNames.Id(name));

    public bool HasBuffer(int nameID) => Sheet.Buffers.ContainsKey(nameID);

    public bool HasConstantBuffer(string name) => HasConstantBuffer(ShaderNames.Id(name));

    public bool HasConstantBuffer(int nameID) => Sheet.ConstantBuffers.ContainsKey(nameID);

    public bool HasTexture(string name) => HasTexture(ShaderNames.Id(name));

    public bool HasTexture(int nameID) => Sheet.Textures.ContainsKey(nameID);

    public bool HasProperty(string name) => HasProperty(ShaderNames.Id(name));

    public bool HasProperty(int nameID) => Sheet.Has(nameID);
}
