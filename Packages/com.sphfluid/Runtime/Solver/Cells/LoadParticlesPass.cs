using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Takes particles that came from outside and counts them in cells; later steps count in their last pass.</summary>
    internal sealed class LoadParticlesPass : ComputePass
    {
        private static readonly int CellTotal = Id("_CellTotal");
        private static readonly int ParticleCount = Id("_ParticleCount");

        private readonly ComputeKernel clear, load;

        public LoadParticlesPass(FluidShaderSet shaders)
            : base(shaders, "LoadParticles")
        {
            clear = Kernel("ClearCells");
            load = Kernel();
        }

        public void Record(CommandBuffer cmd, CellState state)
        {
            using (Sample(cmd))
            {
                clear.SetInt(cmd, CellTotal, state.Buffers.CellCount.Count);
                clear.Set(cmd, state.Buffers.CellCount);
                clear.DispatchThreads(cmd, state.Buffers.CellCount.Count);
                CellBindings.SetCells(cmd, load, state.Cells);
                load.SetInt(cmd, ParticleCount, state.LoadedCount);
                load.Set(cmd, state.Published.Particles);
                load.SetOut(cmd, state.Buffers.NewPositions);
                load.SetOut(cmd, state.Buffers.NewVelocities);
                load.Set(cmd, state.Buffers.CellCount);
                load.SetOut(cmd, state.Buffers.Rank);
                load.DispatchThreads(cmd, state.LoadedCount);
            }
        }
    }
}
