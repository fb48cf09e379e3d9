using System.Collections.Generic;
using System.Linq;
using Headless.Engine;
using UnityEngine.Rendering;

namespace UnityEngine;

public partial class Graphics
{
    public static void DrawMesh(Mesh mesh, Vector3 position, Quaternion rotation, Material material, int layer) =>
        DrawMesh(mesh, Matrix4x4.TRS(position, rotation, Vector3.one), material, layer);

    public static void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int layer) => DrawMesh(mesh, matrix, material, layer, null);

    public static void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int layer, Camera? camera) =>
        DrawMesh(mesh, matrix, material, layer, camera, 0);

    public static void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int layer, Camera? camera, int submeshIndex) =>
        DrawMesh(mesh, matrix, material, layer, camera, submeshIndex, null);

    public static void DrawMesh(
        Mesh mesh, Matrix4x4 matrix, Material material, int layer, Camera? camera, int submeshIndex, MaterialPropertyBlock? properties) =>
        DrawMesh(mesh, matrix, material, layer, camera, submeshIndex, properties, true, true);

    public static void DrawMesh(
        Mesh mesh, Matrix4x4 matrix, Material material, int layer, Camera? camera, int submeshIndex, MaterialPropertyBlock? properties, bool castShadows) =>
        DrawMesh(mesh, matrix, material, layer, camera, submeshIndex, properties, castShadows, true);

    public static void DrawMesh(
        Mesh mesh, Matrix4x4 matrix, Material material, int layer, Camera? camera, int submeshIndex, MaterialPropertyBlock? properties,
        bool castShadows, bool receiveShadows) =>
        DrawMesh(
            mesh, matrix, material, layer, camera, submeshIndex, properties, castShadows ? ShadowCastingMode.On : ShadowCastingMode.Off, receiveShadows);

    public static void DrawMesh(
        Mesh mesh, Matrix4x4 matrix, Material material, int layer, Camera? camera, int submeshIndex, MaterialPropertyBlock? properties,
        ShadowCastingMode castShadows, bool receiveShadows) =>
        RenderMesh(Params(material, layer, camera, properties, castShadows, receiveShadows), mesh, submeshIndex, matrix);

    public static void DrawMeshInstanced(Mesh mesh, int submeshIndex, Material material, Matrix4x4[] matrices) =>
        DrawMeshInstanced(mesh, submeshIndex, material, matrices, matrices.Length);

    public static void DrawMeshInstanced(Mesh mesh, int submeshIndex, Material material, Matrix4x4[] matrices, int count) =>
        DrawMeshInstanced(mesh, submeshIndex, material, matrices, count, null);

    public static void DrawMeshInstanced(
        Mesh mesh, int submeshIndex, Material material, Matrix4x4[] matrices, int count, MaterialPropertyBlock? properties) =>
        RenderMeshInstanced(Params(material, 0, null, properties, ShadowCastingMode.On, true), mesh, submeshIndex, matrices, count);

    public static void DrawMeshInstanced(Mesh mesh, int submeshIndex, Material material, List<Matrix4x4> matrices) =>
        DrawMeshInstanced(mesh, submeshIndex, material, matrices.ToArray());

    public static void DrawMeshInstancedIndirect(
        Mesh mesh, int submeshIndex, Material material, Bounds bounds, GraphicsBuffer bufferWithArgs, int argsOffset = 0,
        MaterialPropertyBlock? properties = null, ShadowCastingMode castShadows = ShadowCastingMode.On, bool receiveShadows = true, int layer = 0,
        Camera? camera = null, LightProbeUsage lightProbeUsage = LightProbeUsage.BlendProbes) =>
        Queue(
            Params(material, layer, camera, properties, castShadows, receiveShadows),
            new IndirectGeometry(mesh.GetTopology(submeshIndex), bufferWithArgs.Storage, argsOffset, 1, null, mesh), Matrix4x4.identity, bounds);

    public static void DrawMeshInstancedIndirect(
        Mesh mesh, int submeshIndex, Material material, Bounds bounds, ComputeBuffer bufferWithArgs, int argsOffset = 0,
        MaterialPropertyBlock? properties = null, ShadowCastingMode castShadows = ShadowCastingMode.On, bool receiveShadows = true, int layer = 0,
        Camera? camera = null, LightProbeUsage lightProbeUsage = LightProbeUsage.BlendProbes) =>
        Queue(
            Params(material, layer, camera, properties, castShadows, receiveShadows),
            new IndirectGeometry(mesh.GetTopology(submeshIndex), bufferWithArgs.Storage, argsOffset, 1, null, mesh), Matrix4x4.identity, bounds);

    public static void DrawProcedural(
        Material material, Bounds bounds, MeshTopology topology, int vertexCount, int instanceCount = 1, Camera? camera = null,
        MaterialPropertyBlock? properties = null, ShadowCastingMode castShadows = ShadowCastingMode.On, bool receiveShadows = true, int layer = 0) =>
        Queue(
            Params(material, layer, camera, properties, castShadows, receiveShadows),
            new ProceduralGeometry(topology, vertexCount, instanceCount), Matrix4x4.identity, bounds);

    public static void DrawProcedural(
        Material material, Bounds bounds, MeshTopology topology, GraphicsBuffer indexBuffer, int indexCount, int instanceCount = 1, Camera? camera = null,
        MaterialPropertyBlock? properties = null, ShadowCastingMode castShadows = ShadowCastingMode.On, bool receiveShadows = true, int layer = 0) =>
        Queue(
            Params(material, layer, camera, properties, castShadows, receiveShadows),
            new ProceduralGeometry(topology, indexCount, instanceCount, indexBuffer.Storage), Matrix4x4.identity, bounds);

    public static void DrawProceduralIndirect(
        Material material, Bounds bounds, MeshTopology topology, GraphicsBuffer bufferWithArgs, int argsOffset = 0, Camera? camera = null,
        MaterialPropertyBlock? properties = null, ShadowCastingMode castShadows = ShadowCastingMode.On, bool receiveShadows = true, int layer = 0) =>
        Queue(
            Params(material, layer, camera, properties, castShadows, receiveShadows),
            new IndirectGeometry(topology, bufferWithArgs.Storage, argsOffset, 1, null, null), Matrix4x4.identity, bounds);

    public static void DrawProceduralIndirect(
        Material material, Bounds bounds, MeshTopology topology, ComputeBuffer bufferWithArgs, int argsOffset = 0, Camera? camera = null,
        MaterialPropertyBlock? properties = null, ShadowCastingMode castShadows = ShadowCastingMode.On, bool receiveShadows = true, int layer = 0) =>
        Queue(
            Params(material, layer, camera, properties, castShadows, receiveShadows),
            new IndirectGeometry(topology, bufferWithArgs.Storage, argsOffset, 1, null, null), Matrix4x4.identity, bounds);

    private static RenderParams Params(
        Material material, int layer, Camera? camera, MaterialPropertyBlock? properties, ShadowCastingMode castShadows, bool receiveShadows) =>
        new(material)
        {
            layer = layer,
            camera = camera,
            matProps = properties,
            shadowCastingMode = castShadows,
            receiveShadows = receiveShadows,
        };
}
