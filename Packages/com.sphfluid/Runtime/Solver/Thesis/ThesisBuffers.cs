using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The structured buffers of thesis 6.2.1 that only its own blocks use, and those that the sort needs.</summary>
    public sealed class ThesisBuffers : IDisposable
    {
        GraphicsBuffer sortedParticles;
        GraphicsBuffer grid;
        GraphicsBuffer gridTranspose;
        GraphicsBuffer force;
        GraphicsBuffer acceleration;

        internal ThesisBuffers(int particleCount)
        {
            PaddedCount = BitonicSortPass.PaddedCount(particleCount);
            try
            {
                sortedParticles = GpuBuffers.Create("SortedParticles", particleCount, FluidParticle.Stride);
                grid = GpuBuffers.Create("Grid", PaddedCount, 2 * sizeof(uint));
                gridTranspose = GpuBuffers.Create("GridTranspose", PaddedCount, 2 * sizeof(uint));
                force = GpuBuffers.Create("Force", particleCount, 4 * sizeof(float));
                acceleration = GpuBuffers.Create("Acceleration", particleCount, 4 * sizeof(float));
                Bytes = GpuBuffers.Size(sortedParticles, grid, gridTranspose, force, acceleration);
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        /// <summary>Number of sorted pairs: the next power of two, 1,024 at least.</summary>
        public int PaddedCount { get; }

        /// <summary>Target of the next SortParticles; it is then exchanged with the liquid's particles.</summary>
        public GraphicsBuffer SortedParticles => sortedParticles;

        /// <summary>Pairs (cell, id), uint2.</summary>
        public GraphicsBuffer Grid => grid;

        /// <summary>The pairs as a transposed matrix, while they are sorted.</summary>
        public GraphicsBuffer GridTranspose => gridTranspose;

        /// <summary>Force density on each particle [N/m³], float4, w unused.</summary>
        public GraphicsBuffer Force => force;

        /// <summary>Acceleration of each particle [m/s²], float4, w unused.</summary>
        public GraphicsBuffer Acceleration => acceleration;

        /// <summary>Bytes of all buffers.</summary>
        public long Bytes { get; }

        internal void SwapParticles(FluidBuffers buffers)
        {
            sortedParticles = buffers.ExchangeParticles(sortedParticles);
        }

        /// <summary>Releases the buffers.</summary>
        public void Dispose()
        {
            GpuBuffers.Dispose(ref sortedParticles);
            GpuBuffers.Dispose(ref grid);
            GpuBuffers.Dispose(ref gridTranspose);
            GpuBuffers.Dispose(ref force);
            GpuBuffers.Dispose(ref acceleration);
        }
    }
}
