using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Moves the particles into larger buffers, after the motion of a step that sorts.</summary>
    internal sealed class GrowParticlesPass : ComputePass
    {
        private static readonly int ParticleCount = Id("_ParticleCount");
        private static readonly int OldCountsBegin = Id("_OldCountsBegin");
        private static readonly int OldRankBegin = Id("_OldRankBegin");

        private readonly ComputeKernel kernel;

        public GrowParticlesPass(FluidShaderSet shaders)
            : base(shaders, "GrowParticles")
        {
            kernel = Kernel();
        }

        /// <param name="cmd">Command buffer.</param>
        /// <param name="state">The new buffers.</param>
        /// <param name="old">Those before.</param>
        /// <param name="count">Particles to copy.</param>
        public void Record(CommandBuffer cmd, CellState state, in CellRemains old, int count)
        {
            CellBuffers buffers = state.Buffers;
            using (Sample(cmd))
            {
                kernel.SetBuffer(cmd, buffers.NewPositions.Id, old.NewPositions);
                kernel.SetBuffer(cmd, buffers.NewVelocities.Id, old.NewVelocities);
                kernel.SetBuffer(cmd, buffers.CellTable.Id, old.CellTable);
                kernel.SetBuffer(cmd, state.List.Neighbours.Id, old.Neighbours);
                kernel.SetInt(cmd, OldCountsBegin, old.NeighbourCounts);
                kernel.SetInt(cmd, OldRankBegin, old.Ranks);
                kernel.SetOut(cmd, buffers.NewPositions);
                kernel.SetOut(cmd, buffers.NewVelocities);
                kernel.SetOut(cmd, buffers.Rank);
                kernel.SetOut(cmd, state.List.Counts);
                if (CellBindings.SetCarries(cmd, kernel, state))
                {
                    kernel.SetBuffer(cmd, CellBindings.Carried, old.Carried);
                    kernel.SetBuffer(cmd, CellBindings.CarriedOut, state.Carried);
                }
                kernel.SetInt(cmd, ParticleCount, count);
                kernel.DispatchThreads(cmd, Math.Max(count, old.Ranks)); // the table of the cells goes along
            }
        }
    }

    /// <summary>What a step that sorts leaves of the particles.</summary>
    internal readonly struct CellRemains
    {
        public readonly GraphicsBuffer NewPositions, NewVelocities, CellTable, Neighbours, Carried;
        public readonly int NeighbourCounts, Ranks; // where they begin

        public CellRemains(CellState state)
        {
            NewPositions = state.Buffers.NewPositions;
            NewVelocities = state.Buffers.NewVelocities;
            CellTable = state.Buffers.CellTable;
            Neighbours = state.List.Neighbours;
            NeighbourCounts = state.List.Counts.Begin;
            Ranks = state.Buffers.Rank.Begin;
            Carried = state.Carried != null ? (GraphicsBuffer)state.Carried : null;
        }
    }
}
