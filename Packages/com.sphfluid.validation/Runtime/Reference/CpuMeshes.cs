using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// The triangles that a <see cref="CpuFluidSolver"/> collides with. The arrays hold one element or more: jobs need them.
    /// </summary>
    internal sealed class CpuMeshes : IDisposable
    {
        private readonly List<CpuTriangle> triangles = new List<CpuTriangle>();
        private readonly List<CpuMesh> meshes = new List<CpuMesh>();
        private NativeArray<CpuTriangle> triangleArray = new NativeArray<CpuTriangle>(1, Allocator.Persistent);
        private NativeArray<CpuMesh> meshArray = new NativeArray<CpuMesh>(1, Allocator.Persistent);

        public void Add(IReadOnlyList<Vector3> corners, bool closed)
        {
            if (corners == null || corners.Count == 0 || corners.Count % 3 != 0)
            {
                throw new ArgumentException(
                    $"A mesh has {corners?.Count ?? 0} corners; it must have three for each triangle, and one triangle or more.",
                    nameof(corners));
            }

            double3 low = CpuFluidParticle.Double(corners[0]);
            double3 high = low;
            int first = triangles.Count;
            for (int i = 0; i < corners.Count; i += 3)
            {
                var triangle = new CpuTriangle
                {
                    A = CpuFluidParticle.Double(corners[i]),
                    B = CpuFluidParticle.Double(corners[i + 1]),
                    C = CpuFluidParticle.Double(corners[i + 2]),
                };
                triangles.Add(triangle);
                low = math.min(math.min(low, triangle.A), math.min(triangle.B, triangle.C));
                high = math.max(math.max(high, triangle.A), math.max(triangle.B, triangle.C));
            }

            meshes
                .Add(new CpuMesh
                {
                    BoundsMin = low, BoundsMax = high, FirstTriangle = first, EndTriangle = triangles.Count,
                    Closed = closed
                });
            Dispose();
            triangleArray = new NativeArray<CpuTriangle>(triangles.ToArray(), Allocator.Persistent);
            meshArray = new NativeArray<CpuMesh>(meshes.ToArray(), Allocator.Persistent);
        }

        public CpuCollision Collision(in FluidSolverSettings settings, double3 halfSize, double timeStep, double kick)
        {
            return new CpuCollision
            {
                HalfSize = halfSize,
                Drag = CpuWallDrag.Of(settings, kick),
                TimeStep = timeStep,
                KickStep = kick,
                WallStiffness = settings.Own<ThesisSettings>().WallStiffness,
                WallDamping = settings.Own<ThesisSettings>().WallDamping,
                WallDistance = settings.Own<ThesisSettings>().WallDistance,
                WallReach = settings.Spacing,
                MeshCount = meshes.Count,
                Triangles = triangleArray,
                Meshes = meshArray,
            };
        }

        public void Dispose()
        {
            triangleArray.Dispose();
            meshArray.Dispose();
        }
    }
}
