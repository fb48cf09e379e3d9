using System.Collections.Generic;
using System.Linq;
using Headless.Engine;

namespace UnityEngine.Rendering;

public partial class CommandBuffer
{
    public void SetGlobalFloat(string name, float value) => SetGlobalFloat(ShaderNames.Id(name), value);

    public void SetGlobalFloat(int nameID, float value) => Add(_ => GlobalProperties.Sheet.SetFloat(nameID, value));

    public void SetGlobalInt(string name, int value) => SetGlobalInt(ShaderNames.Id(name), value);

    public void SetGlobalInt(int nameID, int value) => Add(_ => GlobalProperties.Sheet.SetFloat(nameID, value));

    public void SetGlobalInteger(string name, int value) => SetGlobalInteger(ShaderNames.Id(name), value);

    public void SetGlobalInteger(int nameID, int value) => Add(_ => GlobalProperties.Sheet.SetInteger(nameID, value));

    public void SetGlobalVector(string name, Vector4 value) => SetGlobalVector(ShaderNames.Id(name), value);

    public void SetGlobalVector(int nameID, Vector4 value) => Add(_ => GlobalProperties.Sheet.SetVector(nameID, value));

    public void SetGlobalColor(string name, Color value) => SetGlobalColor(ShaderNames.Id(name), value);

    public void SetGlobalColor(int nameID, Color value) => Add(_ => GlobalProperties.Sheet.SetColor(nameID, value));

    public void SetGlobalMatrix(string name, Matrix4x4 value) => SetGlobalMatrix(ShaderNames.Id(name), value);

    public void SetGlobalMatrix(int nameID, Matrix4x4 value) => Add(_ => GlobalProperties.Sheet.SetMatrix(nameID, value));

    public void SetGlobalFloatArray(string propertyName, float[] values) => SetGlobalFloatArray(ShaderNames.Id(propertyName), values);

    public void SetGlobalFloatArray(int nameID, float[] values)
    {
        float[] copy = [.. values];
        Add(_ => GlobalProperties.Sheet.SetFloats(nameID, copy));
    }

    public void SetGlobalFloatArray(string propertyName, List<float> values) => SetGlobalFloatArray(ShaderNames.Id(propertyName), values.ToArray());

    public void SetGlobalFloatArray(int nameID, List<float> values) => SetGlobalFloatArray(nameID, values.ToArray());

    public void SetGlobalVectorArray(string propertyName, Vector4[] values) => SetGlobalVectorArray(ShaderNames.Id(propertyName), values);

    public void SetGlobalVectorArray(int nameID, Vector4[] values)
    {
        Vector4[] copy = [.. values];
        Add(_ => GlobalProperties.Sheet.SetVectors(nameID, copy));
    }

    public void SetGlobalVectorArray(string propertyName, List<Vector4> values) => SetGlobalVectorArray(ShaderNames.Id(propertyName), values.ToArray());

    public void SetGlobalVectorArray(int nameID, List<Vector4> values) => SetGlobalVectorArray(nameID, values.ToArray());

    public void SetGlobalMatrixArray(string propertyName, Matrix4x4[] values) => SetGlobalMatrixArray(ShaderNames.Id(propertyName), values);

    public void SetGlobalMatrixArray(int nameID, Matrix4x4[] values)
    {
        Matrix4x4[] copy = [.. values];
        Add(_ => GlobalProperties.Sheet.SetMatrices(nameID, copy));
    }

    public void SetGlobalMatrixArray(string propertyName, List<Matrix4x4> values) => SetGlobalMatrixArray(ShaderNames.Id(propertyName), values.ToArray());

    public void SetGlobalMatrixArray(int nameID, List<Matrix4x4> values) => SetGlobalMatrixArray(nameID, values.ToArray());

    public void SetGlobalBuffer(string name, ComputeBuffer value) => SetGlobalBuffer(ShaderNames.Id(name), value);

    public void SetGlobalBuffer(int nameID, ComputeBuffer value)
    {
        DeviceBuffer? storage = value?.Storage;
        Add(_ => GlobalProperties.Sheet.SetBuffer(nameID, storage));
    }

    public void SetGlobalConstantBuffer(ComputeBuffer buffer, string name, int offset, int size) =>
        SetGlobalConstantBuffer(buffer, ShaderNames.Id(name), offset, size);

    public void SetGlobalConstantBuffer(ComputeBuffer buffer, int nameID, int offset, int size)
    {
        var slot = new BufferSlot(buffer?.Storage, offset, size);
        Add(_ => GlobalProperties.Sheet.SetConstantBuffer(nameID, slot));
    }

    public void SetGlobalBuffer(string name, GraphicsBuffer value) => SetGlobalBuffer(ShaderNames.Id(name), value);

    public void SetGlobalBuffer(int nameID, GraphicsBuffer value)
    {
        DeviceBuffer? storage = value?.Storage;
        Add(_ => GlobalProperties.Sheet.SetBuffer(nameID, storage));
    }

    public void SetGlobalConstantBuffer(GraphicsBuffer buffer, string name, int offset, int size) =>
        SetGlobalConstantBuffer(buffer, ShaderNames.Id(name), offset, size);

    public void SetGlobalConstantBuffer(GraphicsBuffer buffer, int nameID, int offset, int size)
    {
        var slot = new BufferSlot(buffer?.Storage, offset, size);
        Add(_ => GlobalProperties.Sheet.SetConstantBuffer(nameID, slot));
    }

    public void SetGlobalTexture(string name, RenderTargetIdentifier value) => SetGlobalTexture(ShaderNames.Id(name), value);

    public void SetGlobalTexture(int nameID, RenderTargetIdentifier value) => SetGlobalTexture(nameID, value, RenderTextureSubElement.Default);

    public void SetGlobalTexture(string name, RenderTargetIdentifier value, RenderTextureSubElement element) =>
        SetGlobalTexture(ShaderNames.Id(name), value, element);

    public void SetGlobalTexture(int nameID, RenderTargetIdentifier value, RenderTextureSubElement element) =>
        Add(c => GlobalProperties.Sheet.SetTexture(nameID, new TextureSlot(Source(c, value), 0, element)));

    public void EnableShaderKeyword(string keyword) => Add(_ => GlobalKeywords.Set(keyword, true));

    public void DisableShaderKeyword(string keyword) => Add(_ => GlobalKeywords.Set(keyword, false));

    public void EnableKeyword(in GlobalKeyword keyword) => SetKeyword(keyword, true);

    public void DisableKeyword(in GlobalKeyword keyword) => SetKeyword(keyword, false);

    public void SetKeyword(in GlobalKeyword keyword, bool value)
    {
        string keywordName = keyword.name;
        Add(_ => GlobalKeywords.Set(keywordName, value));
    }

    public void EnableKeyword(Material material, in LocalKeyword keyword) => SetKeyword(material, keyword, true);

    public void DisableKeyword(Material material, in LocalKeyword keyword) => SetKeyword(material, keyword, false);

    public void SetKeyword(Material material, in LocalKeyword keyword, bool value)
    {
        string keywordName = keyword.name;
        Add(_ => material.Keywords.Change(keywordName, value));
    }
}
