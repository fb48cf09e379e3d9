using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A method to make a surface of particles.</summary>
    internal abstract class SurfaceVariant : IDisposable
    {
        /// <summary>A variant.</summary>
        /// <param name="cell">Edge of a cell [dx].</param>
        protected SurfaceVariant(float cell)
        {
            Cell = cell;
        }

        /// <summary>Edge of a cell [dx].</summary>
        public float Cell { get; }

        /// <summary>Whether all of it runs on the GPU, so that its GPU time is its cost.</summary>
        public virtual bool OnGpu => true;

        /// <summary>Whether it can make a surface of a state: of its particles, by default.</summary>
        public virtual bool Takes(SurfaceState state) => state.Field == null;

        /// <summary>Makes the surface. Waits for the GPU.</summary>
        /// <param name="state">The state.</param>
        /// <param name="solver">The particles, their neighbours set up.</param>
        /// <param name="positions">The same particles, those of one of the state's frames [m].</param>
        public abstract SurfaceMesh Mesh(SurfaceState state, FluidSolver solver, Vector3[] positions);

        /// <summary>
        /// Blocks of a sparse surface that only their neighbours' surface led to, since the last call; the particles should have marked
        /// them.
        /// </summary>
        public virtual int TakeLateBlocks() => 0;

        /// <inheritdoc/>
        public abstract void Dispose();
    }
}
