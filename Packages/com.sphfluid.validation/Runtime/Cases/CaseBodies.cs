using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Meshes as the bodies that the Standard method knows. Their colliders are inactive: they touch no scene.</summary>
    sealed class CaseBodies : IDisposable
    {
        readonly CollisionBodies bodies;
        readonly GameObject holder;

        /// <summary>Bodies at rest.</summary>
        /// <param name="meshes">Corners [m], three a triangle, simulation space.</param>
        /// <param name="settings">The liquid's.</param>
        public CaseBodies(IReadOnlyList<Vector3[]> meshes, in FluidSolverSettings settings)
        {
            bodies = new CollisionBodies(settings);
            holder = new GameObject("SPH Fluid case") { hideFlags = HideFlags.HideAndDontSave };
            holder.SetActive(false);
            var solids = new List<ColliderSolid>();
            foreach (Vector3[] corners in meshes)
            {
                var mesh = new TriangleMesh(corners, Enumerable.Range(0, corners.Length).ToArray());
                ColliderState state = ColliderState.Of(holder.AddComponent<MeshCollider>(), ColliderSettings.DomainFriction, Matrix4x4.identity);
                solids.Add(new ColliderSolid(state, settings.Spacing, mesh));
            }
            bodies.Update(solids);
        }

        public void GiveTo(FluidSolver solver) => solver.SetBodies(bodies);

        public void Dispose()
        {
            bodies.Dispose();
            UnityEngine.Object.DestroyImmediate(holder);
        }
    }
}
