using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Marks the particles that leave by drains, because their time is over, or because they are the oldest of a full liquid, before the
    /// motion of a step that sorts.
    /// </summary>
    internal sealed class DrainParticlesPass : ComputePass
    {
        private const int HighestDigit = 24;
        private const int DigitBits = 8;

        private static readonly int DrainZones = Id("_DrainZones");
        private static readonly int SourceCounts = Id("_SourceCounts");
        private static readonly int AgeCounts = Id("_AgeCounts");
        private static readonly int DrainCount = Id("_DrainCount");
        private static readonly int NextId = Id("_NextId");
        private static readonly int BirthCount = Id("_BirthCount");
        private static readonly int MostParticles = Id("_MostParticles");
        private static readonly int RecycledCount = Id("_RecycledCount");
        private static readonly int DigitShift = Id("_DigitShift");
        private static readonly int Expired = Id("_Expired");

        private readonly ComputeKernel drain, count, choose, oldest;

        public DrainParticlesPass(FluidShaderSet shaders)
            : base(shaders, "DrainParticles")
        {
            drain = Kernel();
            count = Kernel("CountAges");
            choose = Kernel("ChooseAge");
            oldest = Kernel("DrainOldest");
        }

        /// <param name="cmd">Command buffer.</param>
        /// <param name="state">The buffers.</param>
        /// <param name="drains">Drains, if any, the particles whose time is over, and those that a full liquid drops.</param>
        /// <param name="places">Where the particles are, in the order of the last sort.</param>
        public void Record(CommandBuffer cmd, CellState state, in DrainBatch drains, FluidBuffer places)
        {
            using (Sample(cmd))
            {
                BindParticles(cmd, drain, state);
                drain.SetBuffer(cmd, DrainZones, drains.Zones);
                drain.SetBuffer(cmd, SourceCounts, drains.Counts);
                drain.SetInt(cmd, DrainCount, drains.Count);
                drain.SetBuffer(cmd, Expired, drains.Expired);
                drain.Set(cmd, state.Buffers.Velocities);
                drain.SetBuffer(cmd, state.Buffers.PositionTerms.Id, places);
                drain.SetOut(cmd, state.Buffers.Rank);
                drain.DispatchThreads(cmd, state.ParticleCount);
                if (drains.Recycles) RecordOldest(cmd, state, drains);
            }
        }

        private void RecordOldest(CommandBuffer cmd, CellState state, in DrainBatch drains)
        {
            int nextId = unchecked((int)drains.NextId);
            for (int shift = HighestDigit; shift >= 0; shift -= DigitBits)
            {
                BindParticles(cmd, count, state);
                count.Set(cmd, state.Buffers.Velocities);
                count.SetBuffer(cmd, AgeCounts, drains.Ages);
                count.SetInt(cmd, NextId, nextId);
                count.SetInt(cmd, DigitShift, shift);
                count.DispatchThreads(cmd, state.ParticleCount);
                BindParticles(cmd, choose, state);
                choose.SetBuffer(cmd, AgeCounts, drains.Ages);
                choose.SetInt(cmd, BirthCount, drains.Births);
                choose.SetInt(cmd, MostParticles, drains.MostParticles);
                choose.SetInt(cmd, DigitShift, shift);
                choose.DispatchThreads(cmd, 1);
            }
            BindParticles(cmd, oldest, state);
            oldest.Set(cmd, state.Buffers.Velocities);
            oldest.SetBuffer(cmd, AgeCounts, drains.Ages);
            oldest.SetBuffer(cmd, SourceCounts, drains.Counts);
            oldest.SetInt(cmd, NextId, nextId);
            oldest.SetInt(cmd, RecycledCount, drains.RecycledCount);
            oldest.SetOut(cmd, state.Buffers.Rank);
            oldest.DispatchThreads(cmd, state.ParticleCount);
        }

        private static void BindParticles(CommandBuffer cmd, ComputeKernel kernel, CellState state) =>
            CellBindings.SetCells(cmd, kernel, state);
    }
}
