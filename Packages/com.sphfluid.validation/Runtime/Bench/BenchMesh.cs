using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// A sphere of triangles that stands on the floor in the measured liquid. Its collider is inactive: it touches no scene.
    /// </summary>
    internal sealed class BenchMesh : IDisposable
    {
        private const float Radius = 0.12f;

        private static readonly Vector3 Centre = new Vector3(-0.25f * BenchLiquid.Edge, Radius - 0.5f * BenchLiquid.Edge, 0f);

        private readonly FluidObstacles obstacles;
        private GameObject holder;

        public BenchMesh(in FluidSolverSettings settings)
        {
            holder = new GameObject("SPH Fluid benchmark") { hideFlags = HideFlags.HideAndDontSave };
            holder.SetActive(false);
            holder.transform.position = Centre;
            SphereCollider sphere = holder.AddComponent<SphereCollider>();
            sphere.radius = Radius;
            obstacles = new FluidObstacles(settings);
            obstacles.Add(sphere);
            obstacles.Update(Matrix4x4.identity);
        }

        /// <summary>Number of triangles.</summary>
        public int TriangleCount => obstacles.TriangleCount;

        /// <summary>Whether a particle there would overlap the sphere.</summary>
        public static bool Overlaps(Vector3 position, float spacing) => (position - Centre).magnitude < Radius + 0.5f * spacing;

        public void GiveTo(FluidSolver solver) => solver.SetObstacles(obstacles);

        public void Dispose()
        {
            obstacles.Dispose();
            if (holder != null) UnityEngine.Object.DestroyImmediate(holder);
            holder = null;
        }
    }
}
