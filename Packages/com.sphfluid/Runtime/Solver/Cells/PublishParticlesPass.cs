using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Gives the liquid the form that drawing and measurements read, once a frame.</summary>
    internal sealed class PublishParticlesPass : ComputePass
    {
        private static readonly int ParticleCount = Id("_ParticleCount");

        private readonly ComputeKernel particles, ranges;

        public PublishParticlesPass(FluidShaderSet shaders)
            : base(shaders, "PublishParticles")
        {
            particles = Kernel();
            ranges = Kernel("PublishCells");
        }

        public void Record(CommandBuffer cmd, CellState state)
        {
            using (Sample(cmd))
            {
                CellBindings.SetCells(cmd, particles, state);
                particles.SetInt(cmd, ParticleCount, state.ParticleCount);
                if (CellBindings.SetCarriesBesides(cmd, particles, state)) particles.SetBuffer(cmd, CellBindings.Carried, state.Carried);
                else particles.Set(cmd, state.Buffers.Positions);
                particles.Set(cmd, state.Buffers.Velocities);
                particles.Set(cmd, state.List.Densities);
                particles.Set(cmd, state.Buffers.PositionTerms);
                particles.SetOut(cmd, state.Published.Particles);
                particles.Set(cmd, state.Published.Density);
                particles.Set(cmd, state.Published.Pressure);
                particles.DispatchThreads(cmd, state.ParticleCount);
                if (state.Sparse.AreUsed) return; // RankCellsPass
                CellBindings.SetCells(cmd, ranges, state);
                GridNeighbours.SetGrid(cmd, ranges, state.Grid);
                ranges.SetOut(cmd, state.Published.GridIndices);
                ranges.DispatchThreads(cmd, state.Grid.CellCount);
            }
        }
    }
}
