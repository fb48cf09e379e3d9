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
                int counts = state.Buffers.CellTotal + state.Buffers.SumCount;
                clear.SetInt(cmd, CellTotal, counts);
                clear.SetOut(cmd, state.Buffers.CellCount);
                clear.DispatchThreads(cmd, counts);
                CellBindings.SetCells(cmd, load, state.Cells, state.Sparse);
                load.SetInt(cmd, ParticleCount, state.LoadedCount);
                load.Set(cmd, state.Published.Particles);
                load.SetOut(cmd, state.Buffers.NewPositions);
                load.SetOut(cmd, state.Buffers.NewVelocities);
                CellBindings.SetCounts(cmd, load, state);
                if (CellBindings.SetCarriesBesides(cmd, load, state)) load.SetBuffer(cmd, CellBindings.CarriedOut, state.Carried);
                load.DispatchThreads(cmd, state.LoadedCount);
            }
        }
    }
}
