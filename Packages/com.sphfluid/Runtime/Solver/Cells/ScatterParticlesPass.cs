using System;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Particles in the order of their cells: one dispatch, or two for an order without chance.</summary>
    internal sealed class ScatterParticlesPass : ComputePass
    {
        private static readonly int SumCount = Id("_SumCount");

        private readonly ComputeKernel scatter, scatterOrder, reorder;

        public ScatterParticlesPass(FluidShaderSet shaders)
            : base(shaders, "ScatterParticles")
        {
            scatter = Kernel("Scatter");
            scatterOrder = Kernel("ScatterOrder");
            reorder = Kernel("Reorder");
        }

        public void Record(CommandBuffer cmd, CellState state)
        {
            using (Sample(cmd))
            {
                if (state.HasStableOrder)
                {
                    Bind(cmd, scatterOrder, state);
                    scatterOrder.SetOut(cmd, state.Buffers.Order);
                    DispatchAndClear(cmd, scatterOrder, state);
                    Bind(cmd, reorder, state);
                    reorder.Set(cmd, state.Buffers.Order);
                    BindTarget(cmd, reorder, state);
                    reorder.DispatchThreads(cmd, state.ParticleCount);
                }
                else
                {
                    Bind(cmd, scatter, state);
                    BindTarget(cmd, scatter, state);
                    DispatchAndClear(cmd, scatter, state);
                }
            }
        }

        private static void Bind(CommandBuffer cmd, ComputeKernel kernel, CellState state)
        {
            CellBindings.SetCells(cmd, kernel, state);
            kernel.Set(cmd, state.Buffers.NewPositions);
            kernel.Set(cmd, state.Buffers.NewVelocities);
        }

        // A thread a particle, which clears one of the scan's sums as well.
        private static void DispatchAndClear(CommandBuffer cmd, ComputeKernel kernel, CellState state)
        {
            kernel.SetInt(cmd, SumCount, state.Buffers.SumCount);
            CellBindings.SetCounts(cmd, kernel, state);
            kernel.DispatchThreads(cmd, Math.Max(state.ParticleCount, state.Buffers.SumCount));
        }

        private static void BindTarget(CommandBuffer cmd, ComputeKernel kernel, CellState state)
        {
            state.List.SetMeeting(cmd, kernel, state);
            bool carries = CellBindings.SetCarries(cmd, kernel, state);
            if (carries)
            {
                kernel.SetBuffer(cmd, CellBindings.Carried, state.Carried);
                kernel.SetBuffer(cmd, CellBindings.CarriedOut, state.CarriedSorted);
            }

            if (!carries || state.CarriesBesides) kernel.SetOut(cmd, state.Buffers.PositionTerms);
            kernel.SetOut(cmd, state.Buffers.Positions);
            kernel.SetOut(cmd, state.Buffers.Velocities);
        }
    }
}
