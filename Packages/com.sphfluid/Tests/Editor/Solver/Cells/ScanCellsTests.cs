using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>ScanCells against a running sum, at sizes around a group's 2,048 cells around 256 groups and around 2,048.</summary>
    public sealed class ScanCellsTests
    {
        // Cells with the border, and one for those that left: about one group, two, nine, 260, and 2,115.
        [TestCase(3, 3, 3, 28)]
        [TestCase(6, 11, 31, 2047)]
        [TestCase(8, 16, 16, 2049)]
        [TestCase(9, 13, 35, 4096)]
        [TestCase(16, 16, 16, 4097)]
        [TestCase(31, 193, 3, 17950)]
        [TestCase(81, 81, 81, 531442)]
        [TestCase(163, 163, 163, 4330748)]
        public void EachCellBeginsWhereThoseBeforeItEnd(int x, int y, int z, int total)
        {
            const int particleCount = 7;
            const uint behind = 4242u;
            using (new ForcedCells(false))
            using (var rig = new StandardStateRig(StandardStateRig.WithCells(new Vector3Int(x, y, z)), particleCount))
            {
                CellBuffers buffers = rig.State.Buffers;
                int groups = (total + 2047) / 2048;
                Assert.That(buffers.CellTotal + buffers.SumCount, Is.EqualTo(total + 16 * groups));
                var random = new System.Random(total);
                var counts = new uint[total + 16 * groups];
                for (int i = 0; i < total; i++)
                {
                    counts[i] = (uint)Math.Max(0, random.Next(20) - 12);
                    for (uint k = 0u; k < counts[i]; k++) counts[total + 16 * (i / 2048) + random.Next(16)]++;
                }

                buffers.CellCount.SetData(counts);
                var starts = new uint[total + 1];
                Array.Fill(starts, behind);
                buffers.CellTable.SetData(starts);

                var pass = new ScanCellsPass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State));

                buffers.CellTable.GetData(starts);
                uint expected = 0u;
                for (int i = 0; i < total; i++)
                {
                    if (starts[i] != expected) Assert.Fail($"cell {i} of {total} begins at {starts[i]}, not {expected}");
                    expected += counts[i];
                }

                Assert.That(starts[total], Is.EqualTo(expected), "the end of those that left");
                counts = buffers.CellCount.Read<uint>(counts.Length);
                Assert.That(counts.Take(total).All(count => count == 0u), Is.True, "cleared for the next step");
            }
        }
    }
}
