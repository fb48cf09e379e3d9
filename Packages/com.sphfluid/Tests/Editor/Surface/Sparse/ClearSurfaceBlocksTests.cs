using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>ClearSurfaceBlocks at awkward numbers of blocks.</summary>
    public sealed class ClearSurfaceBlocksTests
    {
        private const uint Canary = 99u;

        // Fewer blocks than counters, a group less one, a group, one more, a prime, and more groups than a row of
        // blocks has.
        [TestCase(1)]
        [TestCase(15)]
        [TestCase(16)]
        [TestCase(17)]
        [TestCase(255)]
        [TestCase(256)]
        [TestCase(257)]
        [TestCase(1009)]
        [TestCase(70001)]
        public void EveryEntryAndEveryCounterIsZero(int blockCount)
        {
            using (var blocks = new SurfaceBlocks())
            {
                blocks.Reserve(RowOf(blockCount), 1);
                Assert.AreEqual(blockCount, blocks.BlockCount);
                Fill(blocks, blockCount);
                Clear(blocks);
                CollectionAssert.AreEqual(new uint[blockCount], GpuTest.Read<uint>(blocks.Table, blockCount));
                CollectionAssert.AreEqual(new uint[SurfaceCounters.Slots],
                    GpuTest.Read<uint>(blocks.Counters, SurfaceCounters.Slots));
            }
        }

        // Buffers do not shrink: a table made for 600 blocks serves 257, and what lies behind them stays.
        [TestCase(1)]
        [TestCase(256)]
        [TestCase(257)]
        public void NothingBehindTheLastBlockIsWritten(int blockCount)
        {
            const int largest = 600;
            using (var blocks = new SurfaceBlocks())
            {
                blocks.Reserve(RowOf(largest), 1);
                blocks.Reserve(RowOf(blockCount), 1);
                Fill(blocks, largest);
                Clear(blocks);
                uint[] table = GpuTest.Read<uint>(blocks.Table, largest);
                Assert.That(table.Take(blockCount), Is.All.EqualTo(0u));
                Assert.That(table.Skip(blockCount), Is.All.EqualTo(Canary));
            }
        }

        // 8 cells a block, less the two of the ring.
        private static Vector3Int RowOf(int blockCount) => new Vector3Int(8 * blockCount - 2, 1, 1);

        private static void Fill(SurfaceBlocks blocks, int entries)
        {
            blocks.Table.SetData(Enumerable.Repeat(Canary, entries).ToArray());
            blocks.Counters.SetData(Enumerable.Repeat(77u, SurfaceCounters.Slots).ToArray());
        }

        private static void Clear(SurfaceBlocks blocks)
        {
            var pass = new ClearSurfaceBlocksPass(SurfaceTestScene.LoadShaders());
            GpuTest.Run(cmd => pass.Record(cmd, blocks));
        }
    }
}
