using System.Collections.Generic;
using System.Linq;
using System;
using Headless.Engine;
using Unity.Collections;

namespace UnityEngine;

public partial class Graphics
{
    public static void RenderMesh(in RenderParams rparams, Mesh mesh, int submeshIndex, Matrix4x4 objectToWorld, Matrix4x4? prevObjectToWorld = null)
    {
        Bounds bounds = BoundsTransform.ToWorld(Require(mesh, nameof(mesh)).bounds, objectToWorld);
        Queue(rparams, new MeshGeometry(mesh, submeshIndex, 1), objectToWorld, bounds);
    }

    public static void RenderMeshIndirect(in RenderParams rparams, Mesh mesh, GraphicsBuffer commandBuffer, int commandCount = 1, int startCommand = 0) =>
        Queue(
            rparams,
            new IndirectGeometry(
                Require(mesh, nameof(mesh)).GetTopology(0), Require(commandBuffer, nameof(commandBuffer)).Storage,
                (long)startCommand * GraphicsBuffer.IndirectDrawIndexedArgs.size, commandCount, null, mesh),
            Matrix4x4.identity, rparams.worldBounds);

    public static void RenderMeshPrimitives(in RenderParams rparams, Mesh mesh, int submeshIndex, int instanceCount = 1) =>
        Queue(rparams, new MeshGeometry(Require(mesh, nameof(mesh)), submeshIndex, instanceCount), Matrix4x4.identity, rparams.worldBounds);

    public static void RenderPrimitives(in RenderParams rparams, MeshTopology topology, int vertexCount, int instanceCount = 1) =>
        Queue(rparams, new ProceduralGeometry(topology, vertexCount, instanceCount), Matrix4x4.identity, rparams.worldBounds);

    public static void RenderPrimitivesIndexed(
        in RenderParams rparams, MeshTopology topology, GraphicsBuffer indexBuffer, int indexCount, int startIndex = 0, int instanceCount = 1) =>
        Queue(
            rparams, new ProceduralGeometry(topology, indexCount, instanceCount, Require(indexBuffer, nameof(indexBuffer)).Storage, startIndex),
            Matrix4x4.identity, rparams.worldBounds);

    public static void RenderPrimitivesIndirect(
        in RenderParams rparams, MeshTopology topology, GraphicsBuffer commandBuffer, int commandCount = 1, int startCommand = 0) =>
        Queue(
            rparams,
            new IndirectGeometry(
                topology, Require(commandBuffer, nameof(commandBuffer)).Storage,
                (long)startCommand * GraphicsBuffer.IndirectDrawArgs.size, commandCount, null, null),
            Matrix4x4.identity, rparams.worldBounds);

    public static void RenderPrimitivesIndexedIndirect(
        in RenderParams rparams, MeshTopology topology, GraphicsBuffer indexBuffer, GraphicsBuffer commandBuffer, int commandCount = 1, int startCommand = 0) =>
        Queue(
            rparams,
            new IndirectGeometry(
                topology, Require(commandBuffer, nameof(commandBuffer)).Storage,
                (long)startCommand * GraphicsBuffer.IndirectDrawIndexedArgs.size, commandCount, Require(indexBuffer, nameof(indexBuffer)).Storage, null),
            Matrix4x4.identity, rparams.worldBounds);

    public static void RenderMeshInstanced<T>(
        in RenderParams rparams, Mesh mesh, int submeshIndex, T[] instanceData, int instanceCount = -1, int startInstance = 0)
        where T : unmanaged => Instances<T>(rparams, mesh, submeshIndex, instanceData, instanceCount, startInstance);

    public static void RenderMeshInstanced<T>(
        in RenderParams rparams, Mesh mesh, int submeshIndex, List<T> instanceData, int instanceCount = -1, int startInstance = 0)
        where T : unmanaged => Instances<T>(rparams, mesh, submeshIndex, instanceData.ToArray(), instanceCount, startInstance);

    public static void RenderMeshInstanced<T>(
        RenderParams rparams, Mesh mesh, int submeshIndex, NativeArray<T> instanceData, int instanceCount = -1, int startInstance = 0)
        where T : unmanaged => Instances(rparams, mesh, submeshIndex, NativeSpans.Read(instanceData), instanceCount, startInstance);

    private static void Instances<T>(
        in RenderParams rparams, Mesh mesh, int submeshIndex, ReadOnlySpan<T> data, int instanceCount, int startInstance)
        where T : unmanaged
    {
        // Instance data begins with objectToWorld: a Matrix4x4 by itself, or a struct with it as the first field.
        int size = NativeSpans.SizeOf<T>();
        if (size < 64)
        {
            throw new ArgumentException($"RenderMeshInstanced: instance data {typeof(T).Name} must begin with a Matrix4x4 objectToWorld.");
        }

        int count = instanceCount < 0 ? data.Length - startInstance : instanceCount;
        ReadOnlySpan<byte> bytes = NativeSpans.BytesOf(data);
        for (int i = 0; i < count; i++)
        {
            var matrix = System.Runtime.InteropServices.MemoryMarshal.Read<Matrix4x4>(bytes[((startInstance + i) * size)..]);
            RenderMesh(rparams, mesh, submeshIndex, matrix);
        }
    }

    private static T Require<T>(T value, string name)
        where T : class => value ?? throw new ArgumentNullException(name);

    private static void Queue(in RenderParams rparams, DrawGeometry geometry, Matrix4x4 matrix, Bounds bounds)
    {
        if (rparams.material == null)
        {
            throw new ArgumentNullException(nameof(rparams), "RenderParams.material is null: a draw needs a material.");
        }

        DrawQueue.Add(new DrawRequest
        {
            Material = rparams.material,
            Geometry = geometry,
            Block = rparams.matProps?.Sheet.Clone(),
            Matrix = matrix,
            Bounds = bounds,
            Layer = rparams.layer,
            Camera = rparams.camera,
            Shadows = rparams.shadowCastingMode,
            ReceiveShadows = rparams.receiveShadows,
            Reflections = rparams.reflectionProbeUsage,
            RenderingLayers = rparams.renderingLayerMask,
            Motion = rparams.motionVectorMode,
            Priority = rparams.rendererPriority,
        });
    }
}
