using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A sphere of triangles that stands on the floor in the measured liquid. Its collider is inactive: it touches no scene.</summary>
    sealed class BenchMesh : IDisposable
    {
        const float Radius = 0.12f;

        static readonly Vector3 Centre = new Vector3(-0.25f * BenchLiquid.Edge, Radius - 0.5f * BenchLiquid.Edge, 0f);

        readonly CollisionBodies bodies;
        GameObject holder;

        public BenchMesh(in FluidSolverSettings settings)
        {
            bodies = new CollisionBodies(settings);
            holder = new GameObject("SPH Fluid benchmark") { hideFlags = HideFlags.HideAndDontSave };
            holder.SetActive(false);
            holder.transform.position = Centre;
            SphereCollider sphere = holder.AddComponent<SphereCollider>();
            sphere.radius = Radius;
            ColliderState state = ColliderState.Of(sphere, ColliderSettings.DomainFriction, Matrix4x4.identity);
            TriangleMesh mesh = new ColliderTriangles().Make(state, settings.Spacing, new List<FluidMessage>());
            bodies.Update(new[] { new ColliderSolid(state, settings.Spacing, mesh) });
        }

        /// <summary>Number of triangles.</summary>
        public int TriangleCount => bodies.TriangleCount;

        /// <summary>Whether a particle there would overlap the sphere.</summary>
        public static bool Overlaps(Vector3 position, float spacing) => (position - Centre).magnitude < Radius + 0.5f * spacing;

        public void GiveTo(FluidSolver solver) => solver.SetBodies(bodies);

        public void Dispose()
        {
            bodies.Dispose();
            if (holder != null)
                UnityEngine.Object.DestroyImmediate(holder);
            holder = null;
        }
    }
}
