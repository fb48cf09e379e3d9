using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering;

/// <summary>Of passes that draw nothing.</summary>
public class ComputeCommandBuffer : BaseCommandBuffer
{
    internal ComputeCommandBuffer(CommandBuffer wrapped)
        : base(wrapped)
    {
    }

    public void BeginSample(string name) => Wrapped.BeginSample(name);

    public void EndSample(string name) => Wrapped.EndSample(name);

    public void SetGlobalFloat(string name, float value) => Global().SetGlobalFloat(name, value);

    public void SetGlobalFloat(int nameID, float value) => Global().SetGlobalFloat(nameID, value);

    public void SetGlobalInt(string name, int value) => Global().SetGlobalInt(name, value);

    public void SetGlobalInt(int nameID, int value) => Global().SetGlobalInt(nameID, value);

    public void SetGlobalVector(string name, Vector4 value) => Global().SetGlobalVector(name, value);

    public void SetGlobalVector(int nameID, Vector4 value) => Global().SetGlobalVector(nameID, value);

    public void SetGlobalColor(int nameID, Color value) => Global().SetGlobalColor(nameID, value);

    public void SetGlobalMatrix(string name, Matrix4x4 value) => Global().SetGlobalMatrix(name, value);

    public void SetGlobalMatrix(int nameID, Matrix4x4 value) => Global().SetGlobalMatrix(nameID, value);

    public void SetGlobalFloatArray(int nameID, float[] values) => Global().SetGlobalFloatArray(nameID, values);

    public void SetGlobalVectorArray(int nameID, Vector4[] values) => Global().SetGlobalVectorArray(nameID, values);

    public void SetGlobalMatrixArray(int nameID, Matrix4x4[] values) => Global().SetGlobalMatrixArray(nameID, values);

    public void SetGlobalBuffer(string name, GraphicsBuffer value) => Global().SetGlobalBuffer(name, value);

    public void SetGlobalBuffer(int nameID, GraphicsBuffer value) => Global().SetGlobalBuffer(nameID, value);

    public void SetGlobalConstantBuffer(GraphicsBuffer buffer, string name, int offset, int size) => Global().SetGlobalConstantBuffer(buffer, name, offset, size);

    public void SetGlobalTexture(string name, TextureHandle value) => Global().SetGlobalTexture(name, Read(value));

    public void SetGlobalTexture(int nameID, TextureHandle value) => Global().SetGlobalTexture(nameID, Read(value));

    public void SetGlobalTexture(int nameID, TextureHandle value, RenderTextureSubElement element) => Global().SetGlobalTexture(nameID, Read(value), element);

    public void EnableShaderKeyword(string keyword) => Global().EnableShaderKeyword(keyword);

    public void DisableShaderKeyword(string keyword) => Global().DisableShaderKeyword(keyword);

    public void SetKeyword(in GlobalKeyword keyword, bool value) => Global().SetKeyword(keyword, value);

    public void DispatchCompute(ComputeShader computeShader, int kernelIndex, int threadGroupsX, int threadGroupsY, int threadGroupsZ) =>
        Wrapped.DispatchCompute(computeShader, kernelIndex, threadGroupsX, threadGroupsY, threadGroupsZ);

    public void SetComputeBufferParam(ComputeShader computeShader, int kernelIndex, int nameID, GraphicsBuffer buffer) =>
        Wrapped.SetComputeBufferParam(computeShader, kernelIndex, nameID, buffer);

    public void SetComputeTextureParam(ComputeShader computeShader, int kernelIndex, int nameID, TextureHandle rt) =>
        Wrapped.SetComputeTextureParam(computeShader, kernelIndex, nameID, Read(rt));

    public void SetComputeVectorParam(ComputeShader computeShader, int nameID, Vector4 val) => Wrapped.SetComputeVectorParam(computeShader, nameID, val);

    public void SetComputeFloatParam(ComputeShader computeShader, int nameID, float val) => Wrapped.SetComputeFloatParam(computeShader, nameID, val);

    public void SetComputeIntParam(ComputeShader computeShader, int nameID, int val) => Wrapped.SetComputeIntParam(computeShader, nameID, val);
}
