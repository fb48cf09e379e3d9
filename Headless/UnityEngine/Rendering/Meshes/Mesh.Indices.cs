using System.Collections.Generic;
using System.Runtime.InteropServices;
using System;
using Headless.Engine;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Mesh
{
    public int[] triangles
    {
        get
        {
            var all = new List<int>();
            for (int i = 0; i < subMeshes.Count; i++)
            {
                if (subMeshes[i].topology == MeshTopology.Triangles)
                {
                    all.AddRange(GetIndices(i));
                }
            }

            return [.. all];
        }
        set
        {
            subMeshes.Clear();
            subMeshes.Add(new SubMeshDescriptor(0, 0));
            indices = [];
            SetTriangles(value, 0);
        }
    }

    public int[] GetTriangles(int submesh) => GetTriangles(submesh, true);

    public int[] GetTriangles(int submesh, bool applyBaseVertex) => GetIndices(submesh, applyBaseVertex);

    public void GetTriangles(List<int> triangles, int submesh) => Fill(triangles, GetTriangles(submesh));

    public void GetTriangles(List<int> triangles, int submesh, bool applyBaseVertex) => Fill(triangles, GetTriangles(submesh, applyBaseVertex));

    public int[] GetIndices(int submesh) => GetIndices(submesh, true);

    public int[] GetIndices(int submesh, bool applyBaseVertex)
    {
        SubMeshDescriptor part = GetSubMesh(submesh);
        if (!MayAccess("triangles/indices"))
        {
            return [];
        }

        int[] part0 = indices[part.indexStart..(part.indexStart + part.indexCount)];
        return applyBaseVertex && part.baseVertex != 0 ? Array.ConvertAll(part0, i => i + part.baseVertex) : part0;
    }

    public void GetIndices(List<int> indices, int submesh) => Fill(indices, GetIndices(submesh));

    public void GetIndices(List<int> indices, int submesh, bool applyBaseVertex) => Fill(indices, GetIndices(submesh, applyBaseVertex));

    public uint GetIndexStart(int submesh) => (uint)GetSubMesh(submesh).indexStart;

    public uint GetIndexCount(int submesh) => (uint)GetSubMesh(submesh).indexCount;

    public uint GetBaseVertex(int submesh) => (uint)GetSubMesh(submesh).baseVertex;

    public MeshTopology GetTopology(int submesh) => GetSubMesh(submesh).topology;

    public SubMeshDescriptor GetSubMesh(int index)
    {
        RequireSubMesh(index);
        return subMeshes[index];
    }

    public void SetTriangles(int[] triangles, int submesh) => SetTriangles(triangles, submesh, true);

    public void SetTriangles(int[] triangles, int submesh, bool calculateBounds) => SetTriangles(triangles, submesh, calculateBounds, 0);

    public void SetTriangles(int[] triangles, int submesh, bool calculateBounds, int baseVertex) =>
        SetPart(triangles, MeshTopology.Triangles, submesh, calculateBounds, baseVertex);

    public void SetTriangles(int[] triangles, int trianglesStart, int trianglesLength, int submesh, bool calculateBounds = true, int baseVertex = 0) =>
        SetPart(triangles.AsSpan(trianglesStart, trianglesLength), MeshTopology.Triangles, submesh, calculateBounds, baseVertex);

    public void SetTriangles(List<int> triangles, int submesh) => SetTriangles(triangles, submesh, true);

    public void SetTriangles(List<int> triangles, int submesh, bool calculateBounds) => SetTriangles(triangles, submesh, calculateBounds, 0);

    public void SetTriangles(List<int> triangles, int submesh, bool calculateBounds, int baseVertex) =>
        SetPart(CollectionsMarshal.AsSpan(triangles), MeshTopology.Triangles, submesh, calculateBounds, baseVertex);

    public void SetTriangles(ushort[] triangles, int submesh, bool calculateBounds = true, int baseVertex = 0) =>
        SetPart(Array.ConvertAll(triangles, i => (int)i), MeshTopology.Triangles, submesh, calculateBounds, baseVertex);

    public void SetIndices(int[] indices, MeshTopology topology, int submesh) => SetIndices(indices, topology, submesh, true);

    public void SetIndices(int[] indices, MeshTopology topology, int submesh, bool calculateBounds) =>
        SetIndices(indices, topology, submesh, calculateBounds, 0);

    public void SetIndices(int[] indices, MeshTopology topology, int submesh, bool calculateBounds, int baseVertex) =>
        SetPart(indices, topology, submesh, calculateBounds, baseVertex);

    public void SetIndices(int[] indices, int indicesStart, int indicesLength, MeshTopology topology, int submesh, bool calculateBounds = true, int baseVertex = 0) =>
        SetPart(indices.AsSpan(indicesStart, indicesLength), topology, submesh, calculateBounds, baseVertex);

    public void SetIndices(List<int> indices, MeshTopology topology, int submesh, bool calculateBounds = true, int baseVertex = 0) =>
        SetPart(CollectionsMarshal.AsSpan(indices), topology, submesh, calculateBounds, baseVertex);

    public void SetIndices(ushort[] indices, MeshTopology topology, int submesh, bool calculateBounds = true, int baseVertex = 0) =>
        SetPart(Array.ConvertAll(indices, i => (int)i), topology, submesh, calculateBounds, baseVertex);

    internal static int VerticesPer(MeshTopology topology) => topology switch
    {
        MeshTopology.Triangles => 3,
        MeshTopology.Quads => 4,
        MeshTopology.Lines => 2,
        _ => 1,
    };

    private void SetPart(ReadOnlySpan<int> values, MeshTopology topology, int submesh, bool calculateBounds, int baseVertex)
    {
        if (!MayAccess("triangles/indices"))
        {
            return;
        }

        RequireSubMesh(submesh);
        if (values.Length % VerticesPer(topology) != 0)
        {
            Debug.LogError($"Failed setting triangles. The number of supplied triangle indices must be a multiple of {VerticesPer(topology)}: {values.Length} on mesh '{name}'.");
            return;
        }

        foreach (int index in values)
        {
            if ((uint)(index + baseVertex) >= (uint)vertexCount)
            {
                Debug.LogError($"Failed setting triangles. Some indices are referencing out of bounds vertices: {index} with base vertex {baseVertex}, while mesh '{name}' has {vertexCount} vertices.");
                return;
            }

            if (format == IndexFormat.UInt16 && index > ushort.MaxValue)
            {
                Debug.LogError($"Failed setting triangles. Index {index} needs 32-bit indices: set Mesh.indexFormat of '{name}' to UInt32.");
                return;
            }
        }

        SubMeshDescriptor part = subMeshes[submesh];
        indices = [.. indices[..part.indexStart], .. values, .. indices[(part.indexStart + part.indexCount)..]];
        int growth = values.Length - part.indexCount;
        for (int i = 0; i < subMeshes.Count; i++)
        {
            SubMeshDescriptor other = subMeshes[i];
            if (i != submesh && other.indexStart >= part.indexStart + part.indexCount && (i > submesh || other.indexStart > part.indexStart))
            {
                other.indexStart += growth;
                subMeshes[i] = other;
            }
        }

        part.indexCount = values.Length;
        part.topology = topology;
        part.baseVertex = baseVertex;
        subMeshes[submesh] = part;
        if (calculateBounds)
        {
            RecalculateBounds();
        }

        Changed();
    }

    private void RequireSubMesh(int index)
    {
        if ((uint)index >= (uint)subMeshes.Count)
        {
            throw new ArgumentException($"Sub-mesh index {index} is out of bounds: mesh '{name}' has {subMeshes.Count} sub-meshes.", nameof(index));
        }
    }
}
