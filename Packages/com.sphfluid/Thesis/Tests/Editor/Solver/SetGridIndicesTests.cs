using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Block 6.2.5 on sorted pairs that the test makes.</summary>
    public sealed class SetGridIndicesTests
    {
        // What lies in cells without particles, which the block leaves alone.
        private const uint Canary = 77777u;

        // The cells that the particles are in, of 2,000: all in one, one each, in runs of up to 300, few a cell.
        public enum Kind
        {
            OneCell,
            OneEach,
            LongRuns,
            ShortRuns,
        }

        [Test]
        public void EachCellHasTheRangeOfItsRun([Values(0, 1, 2, 255, 256, 257, 1009)] int count, [Values] Kind kind)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Vector3.one, 0.03f);
            settings.DomainSize = 2f * settings.SupportRadius * new Vector3(1999.5f, 0.5f, 0.5f);
            using (var rig = new ThesisRig(settings, new FluidParticle[count]))
            {
                const int cellCount = 2000;
                Assert.That(rig.State.Grid.CellCount, Is.EqualTo(cellCount));
                uint[] cells = Cells(count, kind, cellCount);
                int padded = rig.State.Buffers.PaddedCount;
                rig.State.Buffers.Grid.SetData(Enumerable.Range(0, padded).SelectMany(i =>
                    new[] { i < count ? cells[i] : uint.MaxValue, (uint)(padded - i) }).ToArray());
                FluidBuffer ranges = rig.State.Published.GridIndices;
                ranges.SetData(Enumerable.Repeat(Canary, 2 * cellCount).ToArray());
                var pass = new SetGridIndicesPass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State));

                uint[] expected = Enumerable.Repeat(Canary, 2 * cellCount).ToArray();
                for (int i = 0; i < count; i++)
                {
                    expected[2 * cells[i]] = (uint)System.Array.IndexOf(cells, cells[i]);
                    expected[2 * cells[i] + 1] = (uint)System.Array.LastIndexOf(cells, cells[i]) + 1u;
                }
                Assert.That(GpuTest.Read<uint>(ranges, 2 * cellCount), Is.EqualTo(expected));
            }
        }

        private static uint[] Cells(int count, Kind kind, int cellCount)
        {
            var random = new System.Random(count);
            var cells = new List<uint>();
            while (cells.Count < count)
            {
                int cell = kind == Kind.OneEach ? cellCount - count + cells.Count : random.Next(cellCount);
                int longest = kind == Kind.LongRuns ? 300 : 4;
                int run = kind == Kind.OneEach ? 1 : kind == Kind.OneCell ? count : random.Next(longest);
                cells.AddRange(Enumerable.Repeat((uint)cell, run));
            }

            return cells.Take(count).OrderBy(cell => cell).ToArray();
        }
    }
}
