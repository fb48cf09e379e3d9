using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Closed meshes of a case on the GPU, in simulation space.</summary>
    sealed class CaseObstacles : IDisposable
    {
        GraphicsBuffer triangles, colliders;
        readonly int count;

        /// <summary>Uploads them.</summary>
        /// <param name="meshes">Corners [m], three a triangle, Cross(B − A, C − A) outward.</param>
        /// <exception cref="ArgumentException">A mesh is empty, its corners are no triangles, or it has no inside.</exception>
        public CaseObstacles(IReadOnlyList<Vector3[]> meshes)
        {
            count = meshes.Count;
            var all = new List<CollisionTriangle>();
            var records = new List<CollisionCollider>();
            foreach (Vector3[] corners in meshes)
            {
                if (corners.Length == 0 || corners.Length % 3 != 0)
                    throw new ArgumentException($"An obstacle has {corners.Length} corners; three a triangle are needed.", nameof(meshes));
                if (!new TriangleMesh(corners, Enumerable.Range(0, corners.Length).ToArray()).IsClosed)
                    throw new ArgumentException($"An obstacle of {corners.Length / 3} triangles is not closed: give it all of its faces, each wound outward.", nameof(meshes));
                records.Add(Record(corners, all));
            }
            if (count == 0)
                return;
            triangles = GpuBuffers.Create("CaseTriangles", all.Count, CollisionTriangle.Stride);
            colliders = GpuBuffers.Create("CaseColliders", count, CollisionCollider.Stride);
            triangles.SetData(all.ToArray());
            colliders.SetData(records.ToArray());
        }

        public void GiveTo(FluidSolver solver) => solver.SetTriangles(triangles, colliders, count);

        public void Dispose()
        {
            GpuBuffers.Dispose(ref triangles);
            GpuBuffers.Dispose(ref colliders);
        }

        static CollisionCollider Record(Vector3[] corners, List<CollisionTriangle> all)
        {
            var record = new CollisionCollider
            {
                BoundsMin = corners[0],
                BoundsMax = corners[0],
                FirstTriangle = (uint)all.Count,
                TriangleCount = (uint)(corners.Length / 3) | CollisionCollider.ClosedBit,
            };
            for (int i = 0; i < corners.Length; i++)
            {
                record.BoundsMin = Vector3.Min(record.BoundsMin, corners[i]);
                record.BoundsMax = Vector3.Max(record.BoundsMax, corners[i]);
                if (i % 3 == 0)
                    all.Add(new CollisionTriangle { A = corners[i], B = corners[i + 1], C = corners[i + 2] });
            }
            return record;
        }
    }
}
