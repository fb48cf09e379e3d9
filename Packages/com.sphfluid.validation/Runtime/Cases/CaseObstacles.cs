using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Meshes of a run on the GPU, in simulation space: closed obstacles, or sheets that a particle can be on either side of.</summary>
    sealed class CaseObstacles : IDisposable
    {
        readonly IReadOnlyList<Vector3[]> meshes;
        GraphicsBuffer triangles, colliders;
        CaseBodies bodies;

        /// <summary>Uploads them.</summary>
        /// <param name="meshes">Corners [m], three a triangle, Cross(B − A, C − A) outward.</param>
        /// <param name="closed">Whether each must have an inside, out of which it pushes.</param>
        /// <exception cref="ArgumentException">A mesh is empty, its corners are no triangles, or it must have an inside and has none.</exception>
        public CaseObstacles(IReadOnlyList<Vector3[]> meshes, bool closed)
        {
            this.meshes = meshes;
            var all = new List<CollisionTriangle>();
            var records = new List<CollisionCollider>();
            foreach (Vector3[] corners in meshes)
            {
                if (corners.Length == 0 || corners.Length % 3 != 0)
                    throw new ArgumentException($"An obstacle has {corners.Length} corners; three a triangle are needed.", nameof(meshes));
                if (closed && !new TriangleMesh(corners, Enumerable.Range(0, corners.Length).ToArray()).IsClosed)
                    throw new ArgumentException($"An obstacle of {corners.Length / 3} triangles is not closed: give it all of its faces, each wound outward.", nameof(meshes));
                records.Add(Record(corners, closed, all));
            }
            if (meshes.Count == 0)
                return;
            triangles = GpuBuffers.Create("CaseTriangles", all.Count, CollisionTriangle.Stride);
            colliders = GpuBuffers.Create("CaseColliders", meshes.Count, CollisionCollider.Stride);
            triangles.SetData(all.ToArray());
            colliders.SetData(records.ToArray());
        }

        /// <summary>Gives them to a solver, for as long as this lives.</summary>
        public void GiveTo(FluidSolver solver)
        {
            if (meshes.Count == 0)
                return;
            if (solver.Kind == FluidMethodKind.Standard)
            {
                bodies ??= new CaseBodies(meshes, solver.Settings);
                bodies.GiveTo(solver);
            }
            else
            {
                solver.SetTriangles(triangles, colliders, meshes.Count);
            }
        }

        public void Dispose()
        {
            bodies?.Dispose();
            GpuBuffers.Dispose(ref triangles);
            GpuBuffers.Dispose(ref colliders);
        }

        static CollisionCollider Record(Vector3[] corners, bool closed, List<CollisionTriangle> all)
        {
            var record = new CollisionCollider
            {
                BoundsMin = corners[0],
                BoundsMax = corners[0],
                FirstTriangle = (uint)all.Count,
                TriangleCount = (uint)(corners.Length / 3) | (closed ? CollisionCollider.ClosedBit : 0u),
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
