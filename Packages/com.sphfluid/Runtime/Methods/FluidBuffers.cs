using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The structured buffers of thesis 6.2.1, and those that the sort and the counters need.</summary>
    public sealed class FluidBuffers : IDisposable
    {
        GraphicsBuffer particles;
        GraphicsBuffer sortedParticles;
        GraphicsBuffer grid;
        GraphicsBuffer gridTranspose;
        GraphicsBuffer gridIndices;
        GraphicsBuffer density;
        GraphicsBuffer pressure;
        GraphicsBuffer force;
        GraphicsBuffer acceleration;
        GraphicsBuffer counters;
        GraphicsBuffer noTriangles;
        GraphicsBuffer noColliders;

        internal FluidBuffers(int particleCount, int cellCount)
        {
            ParticleCount = particleCount;
            PaddedCount = BitonicSortPass.PaddedCount(particleCount);
            try
            {
                particles = GpuBuffers.Create("Particles", particleCount, FluidParticle.Stride);
                sortedParticles = GpuBuffers.Create("SortedParticles", particleCount, FluidParticle.Stride);
                grid = GpuBuffers.Create("Grid", PaddedCount, 2 * sizeof(uint));
                gridTranspose = GpuBuffers.Create("GridTranspose", PaddedCount, 2 * sizeof(uint));
                gridIndices = GpuBuffers.Create("GridIndices", cellCount, 2 * sizeof(uint));
                density = GpuBuffers.Create("Density", particleCount, sizeof(float));
                pressure = GpuBuffers.Create("Pressure", particleCount, sizeof(float));
                force = GpuBuffers.Create("Force", particleCount, 4 * sizeof(float));
                acceleration = GpuBuffers.Create("Acceleration", particleCount, 4 * sizeof(float));
                counters = GpuBuffers.Create("Counters", CounterReadback.Slots, sizeof(uint));
                counters.SetData(new uint[CounterReadback.Slots]);
                noTriangles = GpuBuffers.Create("NoTriangles", 1, 48);
                noColliders = GpuBuffers.Create("NoColliders", 1, 32);
                Bytes = Size(particles, sortedParticles, grid, gridTranspose, gridIndices, density, pressure, force,
                    acceleration, counters, noTriangles, noColliders);
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        /// <summary>Number of particles.</summary>
        public int ParticleCount { get; }

        /// <summary>Number of sorted pairs: the next power of two, 1,024 at least.</summary>
        public int PaddedCount { get; }

        /// <summary>Particles, in the order of the last sort.</summary>
        public GraphicsBuffer Particles => particles;

        /// <summary>Target of the next SortParticles; the two are then exchanged.</summary>
        public GraphicsBuffer SortedParticles => sortedParticles;

        /// <summary>Pairs (cell, id), uint2.</summary>
        public GraphicsBuffer Grid => grid;

        /// <summary>The pairs as a transposed matrix, while they are sorted.</summary>
        public GraphicsBuffer GridTranspose => gridTranspose;

        /// <summary>First and end of each cell's particles, uint2.</summary>
        public GraphicsBuffer GridIndices => gridIndices;

        /// <summary>Density of each particle [kg/m³].</summary>
        public GraphicsBuffer Density => density;

        /// <summary>Pressure of each particle [Pa].</summary>
        public GraphicsBuffer Pressure => pressure;

        /// <summary>Force density on each particle [N/m³], float4, w unused.</summary>
        public GraphicsBuffer Force => force;

        /// <summary>Acceleration of each particle [m/s²], float4, w unused.</summary>
        public GraphicsBuffer Acceleration => acceleration;

        /// <summary>Event counts and maxima, see <see cref="FluidCounters"/>.</summary>
        public GraphicsBuffer Counters => counters;

        /// <summary>Bytes of all buffers.</summary>
        public long Bytes { get; }

        internal GraphicsBuffer NoTriangles => noTriangles;

        internal GraphicsBuffer NoColliders => noColliders;

        static long Size(params GraphicsBuffer[] buffers)
        {
            long bytes = 0;
            foreach (GraphicsBuffer buffer in buffers)
            {
                bytes += (long)buffer.count * buffer.stride;
            }

            return bytes;
        }

        internal void SwapParticles()
        {
            GraphicsBuffer sorted = sortedParticles;
            sortedParticles = particles;
            particles = sorted;
        }

        /// <summary>Releases the buffers.</summary>
        public void Dispose()
        {
            GpuBuffers.Dispose(ref particles);
            GpuBuffers.Dispose(ref sortedParticles);
            GpuBuffers.Dispose(ref grid);
            GpuBuffers.Dispose(ref gridTranspose);
            GpuBuffers.Dispose(ref gridIndices);
            GpuBuffers.Dispose(ref density);
            GpuBuffers.Dispose(ref pressure);
            GpuBuffers.Dispose(ref force);
            GpuBuffers.Dispose(ref acceleration);
            GpuBuffers.Dispose(ref counters);
            GpuBuffers.Dispose(ref noTriangles);
            GpuBuffers.Dispose(ref noColliders);
        }
    }
}
