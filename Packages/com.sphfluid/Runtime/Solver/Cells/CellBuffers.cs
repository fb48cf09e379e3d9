using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>
    /// Particles of methods with a counting sort: positions and velocities lie apart as float4 (a velocity's w is the id), once in the
    /// order of the last sort and once as the step left them, in that order but at their new places. Steps that keep the order go on from
    /// there.
    /// </summary>
    internal sealed class CellBuffers : BufferSet
    {
        /// <summary>
        /// Positions at and in the order of the last sort [m]; w: Shaders/Solver/Cells/NeighbourSearch.hlsl. The search reads
        /// four at a time, so three more stand at the end, whatever they are.
        /// </summary>
        public readonly FluidBuffer Positions;

        /// <summary>Velocities with which the step begins [m/s]; w: the id's bits.</summary>
        public readonly FluidBuffer Velocities;

        /// <summary>
        /// Positions after the step [m]; w: below zero of a particle that left, else what the method takes along: with Standard the density
        /// with which the step began. As long as Positions: methods exchange them.
        /// </summary>
        public readonly FluidBuffer NewPositions;

        /// <summary>Velocities after the step [m/s]; w: the id's bits.</summary>
        public readonly FluidBuffer NewVelocities;

        /// <summary>
        /// Positions with which the step begins [m]; w: p/ρ², and what NewPositions has between the sort and the density.
        /// </summary>
        public readonly FluidBuffer PositionTerms;

        /// <summary>Particles in the order of their cells, as indices, for the stable order.</summary>
        public readonly FluidBuffer Order;

        /// <summary>
        /// First particle of each cell, the number of live particles, and that with those that left in the last step; or those of the cells
        /// with particles: Shaders/Solver/Cells/SparseCells.hlsl.
        /// </summary>
        public readonly FluidBuffer CellTable;

        /// <summary>
        /// Behind them, particles of each cell after the step, and those that left the domain in it, and <see cref="SumCount"/> sums of
        /// them for the scan. Where only cells with particles are stored, the sums of three scans.
        /// </summary>
        public BufferRange CellCount { get; private set; }

        /// <summary>And the place of each particle within its cell.</summary>
        public BufferRange Rank { get; private set; }

        /// <summary>Behind those what <see cref="AwakeGroups"/> lists.</summary>
        public BufferRange GroupLists { get; private set; }

        /// <summary>Cells, and one for those that left the domain; 0 where only those with particles are stored.</summary>
        public readonly int CellTotal;

        /// <summary>Parts of sums of the scan's groups that the next count needs to be 0.</summary>
        public readonly int SumCount;

        private readonly SparseCells sparse;

        public CellBuffers(int particleCount, int cellCount, SparseCells sparse, bool isPlanned = false) : base(isPlanned)
        {
            Positions = AddForEach("Positions", particleCount, 16, 3);
            Velocities = AddForEach("Velocities", particleCount, 16);
            NewPositions = AddForEach("NewPositions", particleCount, 16, 3);
            NewVelocities = AddForEach("NewVelocities", particleCount, 16);
            PositionTerms = AddForEach("PositionTerms", particleCount, 16);
            Order = AddForEach("Order", particleCount, 4);
            this.sparse = sparse;
            CellTotal = sparse.AreUsed ? 0 : cellCount + 1;
            SumCount = CellRows.ScanSums(CellTotal);
            CellTable = AddFor("CellTable", particleCount, 4, particles => GroupsBegin(particles) + AwakeGroups.Words(particles));
            Divide(particleCount);
        }

        public override void Resize(int particleCount, ICollection<IDisposable> replaced)
        {
            base.Resize(particleCount, replaced);
            Divide(particleCount);
        }

        private long CountsBegin(int particleCount) => sparse.AreUsed ? sparse.SumsBegin(particleCount) : CellTotal + 1L;

        private long RanksBegin(int particleCount) =>
            CountsBegin(particleCount) + (sparse.AreUsed ? sparse.SumCount(particleCount) : CellTotal + SumCount);

        private long GroupsBegin(int particleCount) => RanksBegin(particleCount) + particleCount;

        private void Divide(int particleCount)
        {
            CellCount = CellTable.Range("CellCount", CountsBegin(particleCount));
            Rank = CellTable.Range("Rank", RanksBegin(particleCount));
            GroupLists = CellTable.Range("GroupLists", GroupsBegin(particleCount));
            CellTable.SetData(new[] { (uint)sparse.Words }); // tells which table it is
            CellTable.SetData(AwakeGroups.All, GroupLists.Begin);
        }
    }
}
