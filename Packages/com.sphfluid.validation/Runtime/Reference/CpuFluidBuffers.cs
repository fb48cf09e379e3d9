using System;
using Unity.Collections;
using Unity.Mathematics;

namespace SphFluid.Validation
{
    /// <summary>The arrays of a <see cref="CpuFluidSolver"/>, named as those of the solver on the GPU.</summary>
    internal sealed class CpuFluidBuffers : IDisposable
    {
        private NativeArray<long> totals;
        private NativeArray<double> maxima;

        public CpuFluidBuffers(FluidParticle[] particles, int cellCount)
        {
            int count = particles.Length;
            Particles = new NativeArray<CpuFluidParticle>(count, Allocator.Persistent);
            Sorted = new NativeArray<CpuFluidParticle>(count, Allocator.Persistent);
            Cells = new NativeArray<int>(count, Allocator.Persistent);
            Order = new NativeArray<int>(count, Allocator.Persistent);
            First = new NativeArray<int>(cellCount + 1, Allocator.Persistent);
            Density = new NativeArray<double>(count, Allocator.Persistent);
            Pressure = new NativeArray<double>(count, Allocator.Persistent);
            Force = new NativeArray<double3>(count, Allocator.Persistent);
            Acceleration = new NativeArray<double3>(count, Allocator.Persistent);
            Events = new NativeArray<int>(count, Allocator.Persistent);
            totals = new NativeArray<long>(3, Allocator.Persistent);
            maxima = new NativeArray<double>(2, Allocator.Persistent);
            NativeArray<CpuFluidParticle> target = Particles;
            for (int i = 0; i < count; i++) target[i] = new CpuFluidParticle(particles[i]);
        }

        public NativeArray<CpuFluidParticle> Particles { get; private set; }

        public NativeArray<CpuFluidParticle> Sorted { get; private set; }

        public NativeArray<int> Cells { get; }

        /// <summary>First particle of each cell, and the number of all at the end.</summary>
        public NativeArray<int> First { get; }

        public NativeArray<int> Order { get; }

        public NativeArray<double> Density { get; }

        public NativeArray<double> Pressure { get; }

        public NativeArray<double3> Force { get; }

        public NativeArray<double3> Acceleration { get; }

        public NativeArray<int> Events { get; }

        public void SwapParticles()
        {
            NativeArray<CpuFluidParticle> sorted = Sorted;
            Sorted = Particles;
            Particles = sorted;
        }

        public CpuCountJob CountEvents()
        {
            return new CpuCountJob { Particles = Particles, Density = Density, Events = Events, Totals = totals, Maxima = maxima };
        }

        public void ResetMaxima()
        {
            maxima[0] = 0.0;
            maxima[1] = 0.0;
        }

        public FluidCounters ReadCounters(float restDensity)
        {
            return new FluidCounters
            {
                AccelerationLimitHits = totals[0],
                DomainClamps = totals[1],
                NonFinite = totals[2],
                MaxSpeed = (float)maxima[0],
                MaxCompression = (float)(maxima[1] / restDensity - 1.0),
            };
        }

        public void Dispose()
        {
            Particles.Dispose();
            Sorted.Dispose();
            Cells.Dispose();
            Order.Dispose();
            First.Dispose();
            Density.Dispose();
            Pressure.Dispose();
            Force.Dispose();
            Acceleration.Dispose();
            Events.Dispose();
            totals.Dispose();
            maxima.Dispose();
        }
    }
}
