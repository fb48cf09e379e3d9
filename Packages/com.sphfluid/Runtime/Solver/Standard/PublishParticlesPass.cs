using Unity.Profiling;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Gives the liquid the form that drawing and measurements read, once a frame (Shaders/Solver/Standard/PublishParticles.compute).</summary>
    internal sealed class PublishParticlesPass
    {
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker("PublishParticles");

        readonly ComputeKernel particles;
        readonly ComputeKernel ranges;

        public PublishParticlesPass(FluidShaderSet shaders)
        {
            particles = shaders.Kernel("PublishParticles", "PublishParticles");
            ranges = shaders.Kernel("PublishParticles", "PublishCells");
        }

        public void Record(CommandBuffer cmd, FluidState state)
        {
            cmd.BeginSample(Marker);
            particles.SetInt(cmd, FluidShaderIds.ParticleCount, state.ParticleCount);
            particles.SetBuffer(cmd, StandardShaderIds.Positions, state.Standard.Positions);
            particles.SetBuffer(cmd, StandardShaderIds.Velocities, state.Standard.Velocities);
            particles.SetBuffer(cmd, StandardShaderIds.DensityIn, state.Standard.Density);
            particles.SetBuffer(cmd, StandardShaderIds.ParticlesOut, state.Buffers.Particles);
            particles.SetBuffer(cmd, FluidShaderIds.Density, state.Buffers.Density);
            particles.SetBuffer(cmd, FluidShaderIds.Pressure, state.Buffers.Pressure);
            particles.DispatchThreads(cmd, state.ParticleCount);
            CellRowsBinding.Set(cmd, ranges, state.Cells, state.Standard.CellStart);
            GridNeighbours.SetGrid(cmd, ranges, state.Grid);
            ranges.SetBuffer(cmd, StandardShaderIds.GridIndicesOut, state.Buffers.GridIndices);
            ranges.DispatchThreads(cmd, state.Grid.CellCount);
            cmd.EndSample(Marker);
        }
    }
}
