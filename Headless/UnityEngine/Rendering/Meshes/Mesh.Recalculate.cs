using System.Linq;
using System;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Mesh
{
    public void RecalculateBounds() => RecalculateBounds(MeshUpdateFlags.Default);

    public void RecalculateBounds(MeshUpdateFlags flags)
    {
        Vector4[] positions = store.Read(VertexAttribute.Position);
        meshBounds = BoundsOf(positions, 0, positions.Length);
        for (int i = 0; i < subMeshes.Count; i++)
        {
            SubMeshDescriptor part = subMeshes[i];
            if (part.indexCount == 0)
            {
                continue;
            }

            int first = int.MaxValue;
            int last = -1;
            foreach (int index in indices.AsSpan(part.indexStart, part.indexCount))
            {
                first = Math.Min(first, index + part.baseVertex);
                last = Math.Max(last, index + part.baseVertex);
            }

            part.firstVertex = first;
            part.vertexCount = last - first + 1;
            part.bounds = last < positions.Length ? BoundsOf(positions, first, last + 1) : meshBounds;
            subMeshes[i] = part;
        }
    }

    public void RecalculateNormals() => RecalculateNormals(MeshUpdateFlags.Default);

    public void RecalculateNormals(MeshUpdateFlags flags)
    {
        Vector3[] positions = Array.ConvertAll(store.Read(VertexAttribute.Position), v => (Vector3)v);
        var sums = new Vector3[positions.Length];
        ForEachTriangle((a, b, c) =>
        {
            Vector3 face = Vector3.Cross(positions[b] - positions[a], positions[c] - positions[a]);
            sums[a] += face;
            sums[b] += face;
            sums[c] += face;
        });
        SetNormals(Array.ConvertAll(sums, n => n.normalized));
    }

    public void RecalculateTangents() => RecalculateTangents(MeshUpdateFlags.Default);

    public void RecalculateTangents(MeshUpdateFlags flags)
    {
        Vector4[] positions = store.Read(VertexAttribute.Position);
        Vector4[] texcoords = store.Read(VertexAttribute.TexCoord0);
        Vector4[] directions = store.Read(VertexAttribute.Normal);
        if (texcoords.Length == 0 || directions.Length == 0)
        {
            return;
        }

        var along = new Vector3[positions.Length];
        var across = new Vector3[positions.Length];
        ForEachTriangle((a, b, c) =>
        {
            Vector3 e1 = positions[b] - positions[a];
            Vector3 e2 = positions[c] - positions[a];
            Vector2 d1 = texcoords[b] - texcoords[a];
            Vector2 d2 = texcoords[c] - texcoords[a];
            float area = (d1.x * d2.y) - (d2.x * d1.y);
            if (Mathf.Abs(area) < 1e-12f)
            {
                return;
            }

            Vector3 u = ((e1 * d2.y) - (e2 * d1.y)) / area;
            Vector3 v = ((e2 * d1.x) - (e1 * d2.x)) / area;
            foreach (int i in (ReadOnlySpan<int>)[a, b, c])
            {
                along[i] += u;
                across[i] += v;
            }
        });

        var result = new Vector4[positions.Length];
        for (int i = 0; i < result.Length; i++)
        {
            Vector3 n = directions[i];
            Vector3 t = along[i] - (n * Vector3.Dot(n, along[i]));
            t = t.sqrMagnitude > 0f ? t.normalized : Vector3.Cross(n, Mathf.Abs(n.y) < 0.9f ? Vector3.up : Vector3.right).normalized;
            float sign = Vector3.Dot(Vector3.Cross(n, t), across[i]) < 0f ? -1f : 1f;
            result[i] = new Vector4(t.x, t.y, t.z, sign);
        }

        SetTangents(result);
    }

    private static Bounds BoundsOf(Vector4[] positions, int first, int end)
    {
        if (first >= end)
        {
            return default;
        }

        Vector3 min = positions[first];
        Vector3 max = min;
        for (int i = first + 1; i < end; i++)
        {
            min = Vector3.Min(min, positions[i]);
            max = Vector3.Max(max, positions[i]);
        }

        var bounds = new Bounds();
        bounds.SetMinMax(min, max);
        return bounds;
    }

    private void ForEachTriangle(Action<int, int, int> visit)
    {
        foreach (SubMeshDescriptor part in subMeshes)
        {
            int step = part.topology switch
            {
                MeshTopology.Triangles => 3,
                MeshTopology.Quads => 4,
                _ => 0,
            };
            for (int i = 0; step > 0 && i + step <= part.indexCount; i += step)
            {
                int p = part.indexStart + i;
                int b = part.baseVertex;
                visit(indices[p] + b, indices[p + 1] + b, indices[p + 2] + b);
                if (step == 4)
                {
                    visit(indices[p] + b, indices[p + 2] + b, indices[p + 3] + b);
                }
            }
        }
    }
}
