using Headless.Engine;

namespace UnityEngine.Rendering;

public partial class CommandBuffer
{
    public void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material) => DrawMesh(mesh, matrix, material, 0);

    public void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int submeshIndex) => DrawMesh(mesh, matrix, material, submeshIndex, -1);

    public void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int submeshIndex, int shaderPass) =>
        DrawMesh(mesh, matrix, material, submeshIndex, shaderPass, null);

    public void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int submeshIndex, int shaderPass, MaterialPropertyBlock? properties) =>
        Draw(material, shaderPass, properties, new MeshGeometry(Require(mesh), submeshIndex, 1), matrix);

    public void DrawMeshInstanced(Mesh mesh, int submeshIndex, Material material, int shaderPass, Matrix4x4[] matrices) =>
        DrawMeshInstanced(mesh, submeshIndex, material, shaderPass, matrices, matrices.Length);

    public void DrawMeshInstanced(Mesh mesh, int submeshIndex, Material material, int shaderPass, Matrix4x4[] matrices, int count) =>
        DrawMeshInstanced(mesh, submeshIndex, material, shaderPass, matrices, count, null);

    public void DrawMeshInstanced(
        Mesh mesh, int submeshIndex, Material material, int shaderPass, Matrix4x4[] matrices, int count, MaterialPropertyBlock? properties)
    {
        for (int i = 0; i < count; i++)
        {
            DrawMesh(mesh, matrices[i], material, submeshIndex, shaderPass, properties);
        }
    }

    public void DrawMeshInstancedProcedural(
        Mesh mesh, int submeshIndex, Material material, int shaderPass, int count, MaterialPropertyBlock? properties = null) =>
        Draw(material, shaderPass, properties, new MeshGeometry(Require(mesh), submeshIndex, count), Matrix4x4.identity);

    public void DrawRenderer(Renderer renderer, Material material) => DrawRenderer(renderer, material, 0);

    public void DrawRenderer(Renderer renderer, Material material, int submeshIndex) => DrawRenderer(renderer, material, submeshIndex, -1);

    public void DrawRenderer(Renderer renderer, Material material, int submeshIndex, int shaderPass)
    {
        Require(renderer);
        Require(material);
        Add(_ =>
        {
            if (renderer != null && renderer.MeshToDraw is { } mesh)
            {
                Drawer.Draw(material, shaderPass, renderer.Block(submeshIndex), new MeshGeometry(mesh, submeshIndex, 1), renderer.localToWorldMatrix);
            }
        });
    }

    public void DrawProcedural(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, int vertexCount) =>
        DrawProcedural(matrix, material, shaderPass, topology, vertexCount, 1);

    public void DrawProcedural(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, int vertexCount, int instanceCount) =>
        DrawProcedural(matrix, material, shaderPass, topology, vertexCount, instanceCount, null);

    public void DrawProcedural(
        Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, int vertexCount, int instanceCount, MaterialPropertyBlock? properties) =>
        Draw(material, shaderPass, properties, new ProceduralGeometry(topology, vertexCount, instanceCount), matrix);

    public void DrawProcedural(GraphicsBuffer indexBuffer, Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, int indexCount) =>
        DrawProcedural(indexBuffer, matrix, material, shaderPass, topology, indexCount, 1);

    public void DrawProcedural(
        GraphicsBuffer indexBuffer, Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, int indexCount, int instanceCount) =>
        DrawProcedural(indexBuffer, matrix, material, shaderPass, topology, indexCount, instanceCount, null);

    public void DrawProcedural(
        GraphicsBuffer indexBuffer, Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, int indexCount, int instanceCount,
        MaterialPropertyBlock? properties) =>
        Draw(material, shaderPass, properties, new ProceduralGeometry(topology, indexCount, instanceCount, Require(indexBuffer).Storage), matrix);

    public void DrawProceduralIndirect(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, GraphicsBuffer bufferWithArgs) =>
        DrawProceduralIndirect(matrix, material, shaderPass, topology, bufferWithArgs, 0);

    public void DrawProceduralIndirect(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, GraphicsBuffer bufferWithArgs, int argsOffset) =>
        DrawProceduralIndirect(matrix, material, shaderPass, topology, bufferWithArgs, argsOffset, null);

    public void DrawProceduralIndirect(
        Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, GraphicsBuffer bufferWithArgs, int argsOffset, MaterialPropertyBlock? properties) =>
        Draw(material, shaderPass, properties, new IndirectGeometry(topology, Require(bufferWithArgs).Storage, argsOffset, 1, null, null), matrix);

    public void DrawProceduralIndirect(
        GraphicsBuffer indexBuffer, Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, GraphicsBuffer bufferWithArgs, int argsOffset) =>
        DrawProceduralIndirect(indexBuffer, matrix, material, shaderPass, topology, bufferWithArgs, argsOffset, null);

    public void DrawProceduralIndirect(
        GraphicsBuffer indexBuffer, Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, GraphicsBuffer bufferWithArgs, int argsOffset,
        MaterialPropertyBlock? properties) =>
        Draw(
            material, shaderPass, properties,
            new IndirectGeometry(topology, Require(bufferWithArgs).Storage, argsOffset, 1, Require(indexBuffer).Storage, null), matrix);

    public void DrawMeshInstancedIndirect(Mesh mesh, int submeshIndex, Material material, int shaderPass, GraphicsBuffer bufferWithArgs) =>
        DrawMeshInstancedIndirect(mesh, submeshIndex, material, shaderPass, bufferWithArgs, 0, null);

    public void DrawMeshInstancedIndirect(
        Mesh mesh, int submeshIndex, Material material, int shaderPass, GraphicsBuffer bufferWithArgs, int argsOffset, MaterialPropertyBlock? properties) =>
        Draw(
            material, shaderPass, properties,
            new IndirectGeometry(Require(mesh).GetTopology(submeshIndex), Require(bufferWithArgs).Storage, argsOffset, 1, null, mesh), Matrix4x4.identity);

    public void DrawProceduralIndirect(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, ComputeBuffer bufferWithArgs) =>
        DrawProceduralIndirect(matrix, material, shaderPass, topology, bufferWithArgs, 0);

    public void DrawProceduralIndirect(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, ComputeBuffer bufferWithArgs, int argsOffset) =>
        DrawProceduralIndirect(matrix, material, shaderPass, topology, bufferWithArgs, argsOffset, null);

    public void DrawProceduralIndirect(
        Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, ComputeBuffer bufferWithArgs, int argsOffset, MaterialPropertyBlock? properties) =>
        Draw(material, shaderPass, properties, new IndirectGeometry(topology, Require(bufferWithArgs).Storage, argsOffset, 1, null, null), matrix);

    public void DrawProceduralIndirect(
        GraphicsBuffer indexBuffer, Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, ComputeBuffer bufferWithArgs, int argsOffset) =>
        DrawProceduralIndirect(indexBuffer, matrix, material, shaderPass, topology, bufferWithArgs, argsOffset, null);

    public void DrawProceduralIndirect(
        GraphicsBuffer indexBuffer, Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, ComputeBuffer bufferWithArgs, int argsOffset,
        MaterialPropertyBlock? properties) =>
        Draw(
            material, shaderPass, properties,
            new IndirectGeometry(topology, Require(bufferWithArgs).Storage, argsOffset, 1, Require(indexBuffer).Storage, null), matrix);

    public void DrawMeshInstancedIndirect(Mesh mesh, int submeshIndex, Material material, int shaderPass, ComputeBuffer bufferWithArgs) =>
        DrawMeshInstancedIndirect(mesh, submeshIndex, material, shaderPass, bufferWithArgs, 0, null);

    public void DrawMeshInstancedIndirect(
        Mesh mesh, int submeshIndex, Material material, int shaderPass, ComputeBuffer bufferWithArgs, int argsOffset, MaterialPropertyBlock? properties) =>
        Draw(
            material, shaderPass, properties,
            new IndirectGeometry(Require(mesh).GetTopology(submeshIndex), Require(bufferWithArgs).Storage, argsOffset, 1, null, mesh), Matrix4x4.identity);

    private void Draw(Material material, int pass, MaterialPropertyBlock? properties, DrawGeometry geometry, Matrix4x4 matrix) =>
        Add(new DrawCommand(Require(material), pass, properties?.Sheet.Clone(), geometry, matrix));
}
