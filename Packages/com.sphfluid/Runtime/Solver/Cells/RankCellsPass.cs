using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>First particle of each cell with particles, where the domain has too many cells to store those without.</summary>
    internal sealed class RankCellsPass : ComputePass
    {
        private static readonly int Words = Id("_Words");
        private static readonly int Entries = Id("_Entries");
        private static readonly int ScanCount = Id("_ScanCount");
        private static readonly int ScanBegin = Id("_ScanBegin");
        private static readonly int ScanStride = Id("_ScanStride");
        private static readonly int ScanResult = Id("_ScanResult");
        private static readonly int ScanTotal = Id("_ScanTotal");
        private static readonly int CountsBits = Id("_CountsBits");

        private readonly ComputeKernel clear, markStrips, markCells, count, scan, publish;

        public RankCellsPass(FluidShaderSet shaders)
            : base(shaders, "RankCells")
        {
            clear = Kernel("ClearRanks");
            markStrips = Kernel("MarkStrips");
            markCells = Kernel("MarkCells");
            count = Kernel("CountRanked");
            scan = Kernel("ScanRanks");
            publish = Kernel("PublishRanks");
        }

        /// <summary>Before particles that came from outside are loaded.</summary>
        public void RecordLoad(CommandBuffer cmd, CellState state)
        {
            cmd.SetBufferData((GraphicsBuffer)state.Buffers.CellTable, SparseCells.HeadOf(state.Sparse.Words, state.LoadedCount));
        }

        /// <summary>Where a table of all cells is scanned. Each sort has one sample of the pass: benchmarks count them.</summary>
        public void Record(CommandBuffer cmd, CellState state)
        {
            SparseCells sparse = state.Sparse;
            int words = sparse.Words, entries = SparseCells.Entries(state.Capacity), sums = sparse.SumCount(state.Capacity);
            int strips = CellRows.ScanSums(words), cells = strips + CellRows.ScanSums(entries), table = checked((int)sparse.EntriesBegin);
            using (Sample(cmd))
            {
                Bind(cmd, clear, state);
                clear.SetInt(cmd, ScanCount, sums);
                clear.DispatchThreads(cmd, Math.Max(Math.Max(words, entries), sums));
                Mark(cmd, markStrips, state, 0);
                Scan(cmd, state, 0, words, SparseCells.Head, 2, 1, SparseCells.StripCount, true);
                Mark(cmd, markCells, state, strips);
                Scan(cmd, state, strips, entries, table, SparseCells.EntrySize, 1, SparseCells.FilledCount, true);
                count.SetOut(cmd, state.Buffers.Rank);
                Mark(cmd, count, state, cells);
                Scan(cmd, state, cells, entries, table + SparseCells.Start, SparseCells.EntrySize, 0, SparseCells.LiveCount, false);
            }
        }

        /// <summary>For readers of published particles.</summary>
        public void RecordPublish(CommandBuffer cmd, CellState state)
        {
            publish.Set(cmd, state.Buffers.CellTable);
            publish.SetOut(cmd, state.Published.GridIndices);
            SetSizes(cmd, publish, state);
            publish.DispatchThreads(cmd, Math.Max(state.Sparse.Words, SparseCells.Entries(state.Capacity)));
        }

        private static void Mark(CommandBuffer cmd, ComputeKernel kernel, CellState state, int sums)
        {
            Bind(cmd, kernel, state, sums);
            CellBindings.SetCells(cmd, kernel, state.Cells, state.Sparse);
            kernel.Set(cmd, state.Buffers.NewPositions);
            kernel.DispatchThreads(cmd, state.ParticleCount);
        }

        private void Scan(CommandBuffer cmd, CellState state, int sums, int items, int first, int stride, int result, int total, bool bits)
        {
            Bind(cmd, scan, state, sums);
            scan.SetInt(cmd, ScanCount, items);
            scan.SetInt(cmd, ScanBegin, first);
            scan.SetInt(cmd, ScanStride, stride);
            scan.SetInt(cmd, ScanResult, result);
            scan.SetInt(cmd, ScanTotal, total);
            scan.SetBool(cmd, CountsBits, bits);
            scan.DispatchThreads(cmd, CellRows.ScanGroups(items) * scan.GroupSize.x);
        }

        private static void Bind(CommandBuffer cmd, ComputeKernel kernel, CellState state, int sums = 0)
        {
            BufferRange counts = state.Buffers.CellCount;
            kernel.SetOut(cmd, counts.Buffer);
            kernel.SetInt(cmd, counts.BeginId, counts.Begin + sums);
            SetSizes(cmd, kernel, state);
        }

        private static void SetSizes(CommandBuffer cmd, ComputeKernel kernel, CellState state)
        {
            kernel.SetInt(cmd, Words, state.Sparse.Words);
            kernel.SetInt(cmd, Entries, SparseCells.Entries(state.Capacity));
        }
    }
}
