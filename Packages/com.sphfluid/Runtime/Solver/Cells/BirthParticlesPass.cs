using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Brings particles into the liquid, after the motion of a step that sorts.</summary>
    internal sealed class BirthParticlesPass : ComputePass
    {
        // Over dx: nobody is born nearer to another.
        private const float FreeDistance = 0.9f;

        // What goes before in a pipe is pushed back by the liquid outside.
        private const float PumpFreeDistance = 0.6f;

        private static readonly int Births = Id("_Births");
        private static readonly int SourceCounts = Id("_SourceCounts");
        private static readonly int BirthCount = Id("_BirthCount");
        private static readonly int RivalCount = Id("_RivalCount");
        private static readonly int SlotCount = Id("_SlotCount");
        private static readonly int FreeSquared = Id("_FreeSquared");
        private static readonly int PumpFreeSquared = Id("_PumpFreeSquared");
        private static readonly int SupportSquared = Id("_SupportSquared");

        private readonly ComputeKernel kernel;

        public BirthParticlesPass(FluidShaderSet shaders)
            : base(shaders, "BirthParticles")
        {
            kernel = Kernel();
        }

        /// <param name="cmd">Command buffer.</param>
        /// <param name="state">The buffers; they have a slot for each birth.</param>
        /// <param name="births">What is to be born.</param>
        public void Record(CommandBuffer cmd, CellState state, in BirthBatch births)
        {
            float free = FreeDistance * state.Settings.Spacing, pumpFree = PumpFreeDistance * state.Settings.Spacing;
            using (Sample(cmd))
            {
                CellBindings.SetSearch(cmd, kernel, state);
                DomainBindings.SetFaces(cmd, kernel, state.Settings);
                kernel.SetBuffer(cmd, Births, births.Births);
                kernel.SetBuffer(cmd, SourceCounts, births.Counts);
                kernel.SetInt(cmd, BirthCount, births.Count);
                kernel.SetInt(cmd, RivalCount, births.HasRivals ? births.Count : 0);
                kernel.SetInt(cmd, SlotCount, births.Slots);
                kernel.SetFloat(cmd, FreeSquared, free * free);
                kernel.SetFloat(cmd, PumpFreeSquared, pumpFree * pumpFree);
                kernel.SetFloat(cmd, SupportSquared, state.Settings.SupportRadius * state.Settings.SupportRadius);
                kernel.SetOut(cmd, state.Buffers.NewPositions);
                kernel.SetOut(cmd, state.Buffers.NewVelocities);
                kernel.SetOut(cmd, state.List.Counts);
                if (CellBindings.SetCarries(cmd, kernel, state)) kernel.SetBuffer(cmd, CellBindings.CarriedOut, state.Carried);
                CellBindings.SetCounts(cmd, kernel, state);
                kernel.Set(cmd, state.Published.Counters);
                kernel.DispatchThreads(cmd, births.Count);
            }
        }
    }
}
