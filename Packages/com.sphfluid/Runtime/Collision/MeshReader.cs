using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Reads Unity meshes into <see cref="TriangleMesh"/>, once for each state of a mesh.</summary>
    internal sealed class MeshReader
    {
        private readonly Dictionary<Mesh, Entry> entries = new Dictionary<Mesh, Entry>();
        private readonly List<Vector3> vertices = new List<Vector3>();
        private readonly List<int> indices = new List<int>();

        /// <summary>Triangles of a readable mesh in its own space; quads are cut in two, lines and points left out.</summary>
        public TriangleMesh Read(Mesh mesh) => Current(mesh).Triangles;

        /// <summary>
        /// Times that a mesh was read and found to be another than before: shows edits that left counts and bounds as they were.
        /// </summary>
        public int EditionOf(Mesh mesh) => !entries.TryGetValue(mesh, out Entry entry) ? 0 : entry.IsStale &&
            mesh.isReadable ? Current(mesh).Edition : entry.Edition;

        /// <summary>Reads every mesh again when it is next asked for; those that did not change keep their triangles.</summary>
        public void Refresh()
        {
            foreach (Entry entry in entries.Values) entry.IsStale = true;
        }

        private Entry Current(Mesh mesh)
        {
            MeshStamp stamp = MeshStamp.Read(mesh);
            if (!entries.TryGetValue(mesh, out Entry entry))
            {
                GoneKeys.Forget(entries);
                entries.Add(mesh, entry = new Entry { Triangles = ReadAll(mesh) });
            }
            else if (entry.IsStale || !entry.Stamp.Equals(stamp))
            {
                TriangleMesh read = ReadAll(mesh), before = entry.Triangles;
                bool hasTriangles = read.HasTrianglesOf(before);
                if (!hasTriangles || !read.Vertices.AsSpan().SequenceEqual(before.Vertices))
                {
                    entry.Triangles = hasTriangles ? before.Deformed(read.Vertices) : read;
                    entry.Edition++;
                }
            }
            (entry.Stamp, entry.IsStale) = (stamp, false);
            return entry;
        }

        private TriangleMesh ReadAll(Mesh mesh)
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
            return new TriangleMesh(vertices.ToArray(), triangles.ToArray(), null);
        }

        private void AddQuads(List<int> triangles)
        {
            for (int i = 0; i + 3 < indices.Count; i += 4)
            {
                triangles.AddRange(new[] { indices[i], indices[i + 1], indices[i + 2] });
                triangles.AddRange(new[] { indices[i], indices[i + 2], indices[i + 3] });
            }
        }

        private sealed class Entry
        {
            public MeshStamp Stamp;
            public TriangleMesh Triangles;
            public int Edition;
            public bool IsStale;
        }
    }

    /// <summary>What shows cheaply that a mesh has changed: counts and bounds.</summary>
    internal readonly struct MeshStamp : IEquatable<MeshStamp>
    {
        private readonly int vertices;
        private readonly long indices;
        private readonly Bounds bounds;

        private MeshStamp(int vertices, long indices, Bounds bounds)
        {
            this.vertices = vertices;
            this.indices = indices;
            this.bounds = bounds;
        }

        public static MeshStamp Read(Mesh mesh)
        {
            if (mesh == null) return default;
            long indices = 0;
            for (int sub = 0; sub < mesh.subMeshCount; sub++) indices += mesh.GetIndexCount(sub);
            return new MeshStamp(mesh.vertexCount, indices, mesh.bounds);
        }

        public bool Equals(MeshStamp other) =>
            vertices == other.vertices && indices == other.indices && bounds.Equals(other.bounds);

        public override bool Equals(object obj) => obj is MeshStamp other && Equals(other);

        public override int GetHashCode() => HashCode.Combine(vertices, indices);
    }
}
