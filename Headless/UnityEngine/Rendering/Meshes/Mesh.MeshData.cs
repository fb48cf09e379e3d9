using System.Collections.Generic;
using System.Linq;
using System;
using Headless.Engine;
using Unity.Collections;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Mesh
{
    public static MeshDataArray AcquireReadOnlyMeshData(Mesh mesh) => AcquireReadOnlyMeshData(new[] { mesh });

    public static MeshDataArray AcquireReadOnlyMeshData(List<Mesh> meshes) => AcquireReadOnlyMeshData(meshes.ToArray());

    /// <summary>Snapshots: later changes of the meshes do not show in them.</summary>
    public static MeshDataArray AcquireReadOnlyMeshData(Mesh[] meshes)
    {
        foreach (Mesh mesh in meshes)
        {
            if (!mesh.isReadable)
            {
                throw new InvalidOperationException($"Not allowed to access vertex data on mesh '{mesh.name}' (isReadable is false; Read/Write must be enabled in import settings)");
            }
        }

        return new MeshDataArray([.. meshes.Select(m => (Mesh)m.CloneNative())]);
    }

    public struct MeshDataArray : IDisposable
    {
        private readonly Mesh[] copies;

        internal MeshDataArray(Mesh[] copies) => this.copies = copies;

        public int Length => copies?.Length ?? 0;

        public MeshData this[int index] => new(copies[index]);

        public void Dispose()
        {
            foreach (Mesh copy in copies ?? [])
            {
                copy.Kill();
            }
        }
    }

    public struct MeshData
    {
        private readonly Mesh mesh;

        internal MeshData(Mesh mesh) => this.mesh = mesh;

        public int vertexCount => mesh.vertexCount;
        public int vertexBufferCount => mesh.vertexBufferCount;
        public int subMeshCount => mesh.subMeshCount;
        public IndexFormat indexFormat => mesh.indexFormat;

        public bool HasVertexAttribute(VertexAttribute attr) => mesh.HasVertexAttribute(attr);

        public int GetVertexAttributeDimension(VertexAttribute attr) => mesh.GetVertexAttributeDimension(attr);

        public VertexAttributeFormat GetVertexAttributeFormat(VertexAttribute attr) => mesh.GetVertexAttributeFormat(attr);

        public int GetVertexAttributeOffset(VertexAttribute attr) => mesh.GetVertexAttributeOffset(attr);

        public int GetVertexAttributeStream(VertexAttribute attr) => mesh.GetVertexAttributeStream(attr);

        public int GetVertexBufferStride(int stream) => mesh.GetVertexBufferStride(stream);

        public SubMeshDescriptor GetSubMesh(int index) => mesh.GetSubMesh(index);

        public void GetVertices(NativeArray<Vector3> outVertices) => mesh.vertices.CopyTo(NativeSpans.Write(outVertices));

        public void GetNormals(NativeArray<Vector3> outNormals) => mesh.normals.CopyTo(NativeSpans.Write(outNormals));

        public void GetTangents(NativeArray<Vector4> outTangents) => mesh.tangents.CopyTo(NativeSpans.Write(outTangents));

        public void GetColors(NativeArray<Color> outColors) => mesh.colors.CopyTo(NativeSpans.Write(outColors));

        public void GetUVs(int channel, NativeArray<Vector2> outUVs) => mesh.ReadUV(channel).CopyTo(NativeSpans.Write(outUVs));

        public void GetIndices(NativeArray<int> outIndices, int submesh, bool applyBaseVertex = true) =>
            mesh.GetIndices(submesh, applyBaseVertex).CopyTo(NativeSpans.Write(outIndices));

        public void GetIndices(NativeArray<ushort> outIndices, int submesh, bool applyBaseVertex = true) =>
            Array.ConvertAll(mesh.GetIndices(submesh, applyBaseVertex), i => (ushort)i).CopyTo(NativeSpans.Write(outIndices));
    }
}
