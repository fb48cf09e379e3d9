using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering;

/// <summary>Of passes whose targets the render graph sets.</summary>
public class RasterCommandBuffer : BaseCommandBuffer
{
    internal RasterCommandBuffer(CommandBuffer wrapped)
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

    public void SetViewProjectionMatrices(Matrix4x4 view, Matrix4x4 proj) => Wrapped.SetViewProjectionMatrices(view, proj);

    public void SetupCameraProperties(Camera camera) => Between(context => context.SetupCameraProperties(camera));

    public void ClearRenderTarget(bool clearDepth, bool clearColor, Color backgroundColor) => Wrapped.ClearRenderTarget(clearDepth, clearColor, backgroundColor);

    public void ClearRenderTarget(bool clearDepth, bool clearColor, Color backgroundColor, float depth) =>
        Wrapped.ClearRenderTarget(clearDepth, clearColor, backgroundColor, depth);

    public void ClearRenderTarget(RTClearFlags clearFlags, Color backgroundColor, float depth, uint stencil) =>
        Wrapped.ClearRenderTarget(clearFlags, backgroundColor, depth, stencil);

    public void SetViewport(Rect pixelRect) => Wrapped.SetViewport(pixelRect);

    public void EnableScissorRect(Rect scissor) => Wrapped.EnableScissorRect(scissor);

    public void DisableScissorRect() => Wrapped.DisableScissorRect();

    public void SetGlobalDepthBias(float bias, float slopeBias) => Wrapped.SetGlobalDepthBias(bias, slopeBias);

    public void SetInvertCulling(bool invertCulling) => Wrapped.SetInvertCulling(invertCulling);

    public void InvokeOnRenderObjectCallbacks() => Between(context => context.InvokeOnRenderObjectCallback());

    public void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material) => Wrapped.DrawMesh(mesh, matrix, material);

    public void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int submeshIndex, int shaderPass) =>
        Wrapped.DrawMesh(mesh, matrix, material, submeshIndex, shaderPass);

    public void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int submeshIndex, int shaderPass, MaterialPropertyBlock properties) =>
        Wrapped.DrawMesh(mesh, matrix, material, submeshIndex, shaderPass, properties);

    public void DrawRenderer(Renderer renderer, Material material, int submeshIndex, int shaderPass) =>
        Wrapped.DrawRenderer(renderer, material, submeshIndex, shaderPass);

    public void DrawRendererList(RendererList rendererList) => Wrapped.DrawRendererList(rendererList);

    public void DrawProcedural(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, int vertexCount) =>
        Wrapped.DrawProcedural(matrix, material, shaderPass, topology, vertexCount);

    public void DrawProcedural(
        Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, int vertexCount, int instanceCount, MaterialPropertyBlock properties) =>
        Wrapped.DrawProcedural(matrix, material, shaderPass, topology, vertexCount, instanceCount, properties);

    public void DrawProceduralIndirect(
        Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, GraphicsBuffer bufferWithArgs, int argsOffset, MaterialPropertyBlock properties) =>
        Wrapped.DrawProceduralIndirect(matrix, material, shaderPass, topology, bufferWithArgs, argsOffset, properties);

    public void DrawProceduralIndirect(
        GraphicsBuffer indexBuffer, Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, GraphicsBuffer bufferWithArgs, int argsOffset,
        MaterialPropertyBlock properties) =>
        Wrapped.DrawProceduralIndirect(indexBuffer, matrix, material, shaderPass, topology, bufferWithArgs, argsOffset, properties);
}
