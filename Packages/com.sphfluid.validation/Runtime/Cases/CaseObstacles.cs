using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Meshes of a run on the GPU, in simulation space: closed obstacles, or sheets that a particle can be on either side of.
    /// </summary>
    internal sealed class CaseObstacles : IDisposable
    {
        private readonly List<TriangleMesh> meshes = new List<TriangleMesh>();
        private readonly CaseBodies bodies;
        private FluidObstacles obstacles;

        /// <summary>Checks them.</summary>
        /// <param name="meshes">Corners [m], three a triangle, Cross(B − A, C − A) outward.</param>
        /// <param name="closed">Whether each must have an inside, out of which it pushes.</param>
        /// <param name="bodies">Bodies that move; null for none.</param>
        /// <exception cref="ArgumentException">A mesh is empty, its corners are no triangles, or it must have an inside and has
        /// none.</exception>
        public CaseObstacles(IReadOnlyList<Vector3[]> meshes, bool closed, CaseBodies bodies = null)
        {
            this.bodies = bodies;
            foreach (Vector3[] corners in meshes)
            {
                if (corners.Length == 0 || corners.Length % 3 != 0)
                {
                    throw new ArgumentException($"An obstacle has {corners.Length} corners; three a triangle are needed.", nameof(meshes));
                }
                TriangleMesh mesh = TriangleMesh.FromCorners(corners);
                if (closed && !mesh.IsClosed)
                {
                    throw new ArgumentException(
                        $"An obstacle of {corners.Length / 3} triangles is not closed: give it all of its faces, each wound outward.",
                        nameof(meshes));
                }
                this.meshes.Add(mesh);
            }
        }

        /// <summary>Gives them to a solver, for as long as this lives.</summary>
        /// <exception cref="ArgumentException">A body floats, and the method moves none.</exception>
        public void GiveTo(FluidSolver solver)
        {
            if (meshes.Count == 0 && !(bodies?.Count > 0)) return;
            obstacles = new FluidObstacles(solver.Settings);
            foreach (TriangleMesh mesh in meshes) obstacles.Add(mesh, Matrix4x4.identity);
            bodies?.AddTo(obstacles);
            obstacles.Update(Matrix4x4.identity);
            solver.SetObstacles(obstacles);
        }

        public void Dispose() => obstacles?.Dispose();
    }
}
