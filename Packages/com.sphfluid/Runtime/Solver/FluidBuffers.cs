using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The structured buffers that a liquid has with every method; what a method needs besides is its own.</summary>
    public sealed class FluidBuffers : IDisposable
    {
        GraphicsBuffer particles;
        GraphicsBuffer gridIndices;
        GraphicsBuffer density;
        GraphicsBuffer pressure;
        GraphicsBuffer counters;
        GraphicsBuffer noTriangles;
        GraphicsBuffer noColliders;

        internal FluidBuffers(int particleCount, int cellCount)
        {
            ParticleCount = particleCount;
            try
            {
                particles = GpuBuffers.Create("Particles", particleCount, FluidParticle.Stride);
                gridIndices = GpuBuffers.Create("GridIndices", cellCount, 2 * sizeof(uint));
                density = GpuBuffers.Create("Density", particleCount, sizeof(float));
                pressure = GpuBuffers.Create("Pressure", particleCount, sizeof(float));
                counters = GpuBuffers.Create("Counters", CounterReadback.Slots, sizeof(uint));
                counters.SetData(new uint[CounterReadback.Slots]);
                noTriangles = GpuBuffers.Create("NoTriangles", 1, 48);
                noColliders = GpuBuffers.Create("NoColliders", 1, 32);
                Bytes = GpuBuffers.Size(particles, gridIndices, density, pressure, counters, noTriangles, noColliders);
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        /// <summary>Number of particles.</summary>
        public int ParticleCount { get; }

        /// <summary>Particles, in the order of the last sort.</summary>
        public GraphicsBuffer Particles => particles;

        /// <summary>First and end of each cell's particles, uint2.</summary>
        public GraphicsBuffer GridIndices => gridIndices;

        /// <summary>Density of each particle [kg/m³].</summary>
        public GraphicsBuffer Density => density;

        /// <summary>Pressure of each particle [Pa].</summary>
        public GraphicsBuffer Pressure => pressure;

        /// <summary>Event counts and maxima, see <see cref="FluidCounters"/>.</summary>
        public GraphicsBuffer Counters => counters;

        /// <summary>Bytes of all buffers.</summary>
        public long Bytes { get; }

        internal GraphicsBuffer NoTriangles => noTriangles;

        internal GraphicsBuffer NoColliders => noColliders;

        /// <summary>Gives the liquid another buffer of particles.</summary>
        /// <returns>The one that it had; both stay the liquid's and the method's own in exchange.</returns>
        internal GraphicsBuffer ExchangeParticles(GraphicsBuffer other)
        {
            GraphicsBuffer had = particles;
            particles = other;
            return had;
        }

        /// <summary>Releases the buffers.</summary>
        public void Dispose()
        {
            GpuBuffers.Dispose(ref particles);
            GpuBuffers.Dispose(ref gridIndices);
            GpuBuffers.Dispose(ref density);
            GpuBuffers.Dispose(ref pressure);
            GpuBuffers.Dispose(ref counters);
            GpuBuffers.Dispose(ref noTriangles);
            GpuBuffers.Dispose(ref noColliders);
        }
    }
}
