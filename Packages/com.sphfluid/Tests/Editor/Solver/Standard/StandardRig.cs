using System;

namespace SphFluid.Tests
{
    /// <summary>A solver of the Standard method around given particles.</summary>
    internal sealed class StandardRig : IDisposable
    {
        private readonly FluidShaderSet shaders = TestShaders.CreateSet();

        public StandardRig(in FluidSolverSettings settings, FluidParticle[] particles)
        {
            Solver = new FluidSolver(settings, shaders, particles);
        }

        public FluidShaderSet Shaders => shaders;

        public FluidSolver Solver { get; }

        public StandardState State => (StandardState)Solver.State;

        public void Setup() => GpuTest.Run(cmd => Solver.RecordNeighbourSetup(cmd));

        /// <summary>Steps, and the neighbour setup behind them.</summary>
        public void Steps(int count) => GpuTest.Run(cmd =>
        {
            Solver.RecordSteps(cmd, count);
            Solver.RecordNeighbourSetup(cmd);
        });

        public FluidParticle[] Particles() => GpuTest.Read<FluidParticle>(Solver.Particles, Solver.ParticleCount);

        public float[] Densities() => GpuTest.Read<float>(Solver.Density, Solver.ParticleCount);

        public float[] Pressures() => GpuTest.Read<float>(Solver.Pressure, Solver.ParticleCount);

        public void Dispose()
        {
            Solver.Dispose();
            UnityEngine.Object.DestroyImmediate(shaders);
        }
    }
}
