using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Reads Unity meshes into <see cref="TriangleMesh"/>, once for each state of a mesh.</summary>
    internal sealed class MeshReader
    {
        readonly Dictionary<Mesh, (MeshStamp stamp, TriangleMesh triangles)> cache = new Dictionary<Mesh, (MeshStamp, TriangleMesh)>();
        readonly List<Vector3> vertices = new List<Vector3>();
        readonly List<int> indices = new List<int>();

        /// <summary>Triangles of a readable mesh in its own space; quads are cut in two, lines and points left out.</summary>
        public TriangleMesh Read(Mesh mesh)
        {
            MeshStamp stamp = MeshStamp.Of(mesh);
            if (cache.TryGetValue(mesh, out var entry) && entry.stamp.Equals(stamp)) return entry.triangles;
            TriangleMesh triangles = ReadAll(mesh);
            if (entry.triangles != null && triangles.HasTrianglesOf(entry.triangles)) triangles = entry.triangles.Deformed(triangles.Vertices);
            cache[mesh] = (stamp, triangles);
            return triangles;
        }

        /// <summary>Forgets every mesh, so that the next read sees edits that left counts and bounds as they were.</summary>
        public void Clear() => cache.Clear();

        TriangleMesh ReadAll(Mesh mesh)
        {
            mesh.GetVertices(vertices);
            var triangles = new List<int>();
            for (int sub = 0; sub < mesh.subMeshCount; sub++)
            {
                MeshTopology topology = mesh.GetTopology(sub);
                if (topology != MeshTopology.Triangles && topology != MeshTopology.Quads) continue;
                mesh.GetIndices(indices, sub, true);
                if (topology == MeshTopology.Triangles) triangles.AddRange(indices);
                else AddQuads(triangles);
            }
            return new TriangleMesh(vertices.ToArray(), triangles.ToArray());
        }

        void AddQuads(List<int> triangles)
        {
            for (int i = 0; i + 3 < indices.Count; i += 4)
            {
                triangles.AddRange(new[] { indices[i], indices[i + 1], indices[i + 2] });
                triangles.AddRange(new[] { indices[i], indices[i + 2], indices[i + 3] });
            }
        }
    }

    /// <summary>What shows cheaply that a mesh has changed: counts and bounds.</summary>
    internal readonly struct MeshStamp : System.IEquatable<MeshStamp>
    {
        readonly int vertices;
        readonly long indices;
        readonly Bounds bounds;

        MeshStamp(int vertices, long indices, Bounds bounds)
        {
            this.vertices = vertices;
            this.indices = indices;
            this.bounds = bounds;
        }

        public static MeshStamp Of(Mesh mesh)
        {
            if (mesh == null) return default;
            long indices = 0;
            for (int sub = 0; sub < mesh.subMeshCount; sub++) indices += mesh.GetIndexCount(sub);
            return new MeshStamp(mesh.vertexCount, indices, mesh.bounds);
        }

        public bool Equals(MeshStamp other) =>
            vertices == other.vertices && indices == other.indices && bounds.Equals(other.bounds);

        public override bool Equals(object obj) => obj is MeshStamp other && Equals(other);

        public override int GetHashCode() => System.HashCode.Combine(vertices, indices);
    }
}
