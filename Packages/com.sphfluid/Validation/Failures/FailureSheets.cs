using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Open meshes on the GPU: sheets without an inside, which a particle can be on either side of.</summary>
    sealed class FailureSheets : IDisposable
    {
        readonly int count;
        GraphicsBuffer triangles, colliders;

        public FailureSheets(IReadOnlyList<Vector3[]> sheets)
        {
            count = sheets.Count;
            if (count == 0)
                return;
            var all = new List<CollisionTriangle>();
            var records = new List<CollisionCollider>();
            foreach (Vector3[] corners in sheets)
            {
                records.Add(new CollisionCollider
                {
                    BoundsMin = corners.Aggregate(Vector3.Min),
                    BoundsMax = corners.Aggregate(Vector3.Max),
                    FirstTriangle = (uint)all.Count,
                    TriangleCount = (uint)(corners.Length / 3),
                });
                for (int i = 0; i + 2 < corners.Length; i += 3)
                    all.Add(new CollisionTriangle { A = corners[i], B = corners[i + 1], C = corners[i + 2] });
            }
            triangles = GpuBuffers.Create("SheetTriangles", all.Count, CollisionTriangle.Stride);
            colliders = GpuBuffers.Create("Sheets", count, CollisionCollider.Stride);
            triangles.SetData(all.ToArray());
            colliders.SetData(records.ToArray());
        }

        public void GiveTo(FluidSolver solver) => solver.SetTriangles(triangles, colliders, count);

        public void Dispose()
        {
            GpuBuffers.Dispose(ref triangles);
            GpuBuffers.Dispose(ref colliders);
        }
    }
}
