using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Takes particles that came from outside and counts them in cells (Shaders/Solver/Standard/LoadParticles.compute); later steps count in their last pass.</summary>
    internal sealed class LoadParticlesPass
    {
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker("LoadParticles");

        readonly ComputeKernel clear;
        readonly ComputeKernel load;

        public LoadParticlesPass(FluidShaderSet shaders)
        {
            clear = shaders.Kernel("LoadParticles", "ClearCells");
            load = shaders.Kernel("LoadParticles", "LoadParticles");
        }

        public void Record(CommandBuffer cmd, FluidState state)
        {
            cmd.BeginSample(Marker);
            clear.SetInt(cmd, StandardShaderIds.CellTotal, state.Standard.CellCount.count);
            clear.SetBuffer(cmd, StandardShaderIds.CellCount, state.Standard.CellCount);
            clear.DispatchThreads(cmd, state.Standard.CellCount.count);
            CellRowsBinding.Set(cmd, load, state.Cells);
            load.SetInt(cmd, FluidShaderIds.ParticleCount, state.ParticleCount);
            load.SetBuffer(cmd, FluidShaderIds.Particles, state.Buffers.Particles);
            load.SetBuffer(cmd, StandardShaderIds.NewPositionsOut, state.Standard.NewPositions);
            load.SetBuffer(cmd, StandardShaderIds.NewVelocitiesOut, state.Standard.NewVelocities);
            load.SetBuffer(cmd, StandardShaderIds.CellCount, state.Standard.CellCount);
            load.SetBuffer(cmd, StandardShaderIds.RankOut, state.Standard.Rank);
            load.DispatchThreads(cmd, state.ParticleCount);
            cmd.EndSample(Marker);
        }
    }
}
