using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>ListSurfaceBlocks and BeginSurfaceRound at awkward numbers of blocks.</summary>
    public sealed class ListSurfaceBlocksTests
    {
        private FluidShaderSet shaders;

        [SetUp]
        public void SetUp() => shaders = SurfaceTestScene.LoadShaders();

        [TestCase(1, 1.0)]
        [TestCase(255, 0.5)]
        [TestCase(256, 1.0)]
        [TestCase(257, 0.3)]
        [TestCase(1009, 0.0)]
        [TestCase(70001, 0.02)]
        public void MarkedBlocksGetASlotEach(int blockCount, double part)
        {
            using (var blocks = new SurfaceBlocks())
            {
                List<uint> marked = Mark(blocks, blockCount, part, (int)(blockCount * part) + 100);
                uint[] counters = List(blocks);
                Assert.AreEqual(marked.Count, (int)counters[SurfaceCounters.BlocksRequested]);
                Assert.AreEqual(marked.Count, (int)counters[SurfaceCounters.BlocksListed]);
                uint[] list = GpuTest.Read<uint>(blocks.List, marked.Count);
                CollectionAssert.AreEquivalent(marked, list);
                uint[] table = GpuTest.Read<uint>(blocks.Table, blockCount);
                for (int slot = 0; slot < list.Length; slot++) Assert.AreEqual(slot + 1, (int)table[list[slot]]);
                Assert.AreEqual(blockCount - marked.Count, table.Count(entry => entry == 0u));
                CollectionAssert.AreEqual(new[] { (uint)marked.Count, marked.Count > 0 ? 1u : 0u, 1u },
                    GpuTest.Read<uint>(blocks.RoundArguments, 3));
            }
        }

        [Test]
        public void MoreBlocksThanSlotsMakeNoRound()
        {
            using (var blocks = new SurfaceBlocks())
            {
                Mark(blocks, 600, 1.0, 599);
                var untouched = Enumerable.Repeat(-7f, 599 * SurfaceBlocks.SamplesPerBlock).ToArray();
                blocks.Samples.SetData(untouched);
                uint[] counters = List(blocks);
                Assert.AreEqual(600u, counters[SurfaceCounters.BlocksRequested]);
                Assert.AreEqual(0u, counters[SurfaceCounters.BlocksListed]);
                Assert.AreEqual(0u, counters[SurfaceCounters.RoundCount]);
                Assert.AreEqual(0u, GpuTest.Read<uint>(blocks.RoundArguments, 3)[0]);
                BeginLate(blocks);
                Assert.AreEqual(0u, GpuTest.Read<uint>(blocks.Counters, SurfaceCounters.Slots)[SurfaceCounters.BlocksLate]);
            }
        }

        [TestCase(599)]
        [TestCase(256)]
        [TestCase(1)]
        public void NoBlockGetsASlotBeyondTheLast(int capacity)
        {
            var cells = new Vector3Int(78, 78, 46); // 10 x 10 x 6 blocks
            using (var blocks = new SurfaceBlocks())
            {
                blocks.Reserve(cells, capacity);
                Assert.AreEqual(600, blocks.BlockCount);
                Assert.AreEqual(capacity, blocks.Capacity);
                blocks.Table.SetData(Enumerable.Repeat(uint.MaxValue, 600).ToArray());
                blocks.Counters.SetData(new uint[SurfaceCounters.Slots]);
                GpuTest.Run(cmd => new ListSurfaceBlocksPass(shaders).Record(cmd, blocks));
                uint[] slots = GpuTest.Read<uint>(blocks.Table, 600)
                    .Where(entry => entry != uint.MaxValue).OrderBy(entry => entry).ToArray();
                CollectionAssert.AreEqual(Enumerable.Range(1, capacity).Select(i => (uint)i), slots);
            }
        }

        // 5 listed, then 3 more, of which 2 fit.
        [Test]
        public void LateRoundBeginsWhereTheFirstEnded()
        {
            using (var blocks = new SurfaceBlocks())
            {
                Mark(blocks, 5, 1.0, 7);
                uint[] counters = List(blocks);
                counters[SurfaceCounters.BlocksRequested] = 8u;
                blocks.Counters.SetData(counters);
                BeginLate(blocks);
                counters = GpuTest.Read<uint>(blocks.Counters, SurfaceCounters.Slots);
                Assert.AreEqual(5u, counters[SurfaceCounters.RoundFirst]);
                Assert.AreEqual(2u, counters[SurfaceCounters.RoundCount]);
                Assert.AreEqual(2u, counters[SurfaceCounters.BlocksLate]);
                Assert.AreEqual(2u, GpuTest.Read<uint>(blocks.RoundArguments, 3)[0]);
            }
        }

        [Test]
        public void SlotsThatDoNotFitAreNotSampled()
        {
            var domain = new Vector3(0.9f, 0.7f, 0.5f);
            FluidSolverSettings settings = TestSettings.ByRule(domain, 0.05f);
            SurfaceFieldSettings field = SurfaceFieldSettings.For(FluidSurfaceQuality.Default, settings);
            SurfaceGrid grid = SurfaceGrid.OverDomain(domain, field.CellSize);
            using (var rig = new BlockFieldRig(shaders, settings, ParticleSets.Random(500, domain, 0f, 1)))
            {
                rig.Record(field, grid);
                uint requested = rig.Counters()[SurfaceCounters.BlocksRequested];
                using (var small = new BlockFieldRig(shaders, settings, ParticleSets.Random(500, domain, 0f, 1)))
                {
                    small.Blocks.Reserve(grid.Cells, (int)requested - 1);
                    var untouched = Enumerable.Repeat(-7f,
                        small.Blocks.Capacity * SurfaceBlocks.SamplesPerBlock).ToArray();
                    small.Blocks.Samples.SetData(untouched);
                    small.Record(field, grid, (int)requested - 1);
                    Assert.AreEqual(requested, small.Counters()[SurfaceCounters.BlocksRequested]);
                    CollectionAssert.AreEqual(untouched, GpuTest.Read<float>(small.Blocks.Samples, untouched.Length));
                }
            }
        }

        [Test]
        public void ReserveGrowsAndCountsItsBytes()
        {
            using (var blocks = new SurfaceBlocks())
            {
                blocks.Reserve(new Vector3Int(64, 6, 7), 10);
                Assert.AreEqual(new Vector3Int(9, 1, 2), blocks.Counts);
                long before = blocks.Bytes;
                blocks.Reserve(new Vector3Int(64, 6, 7), 20);
                Assert.AreEqual(20, blocks.Capacity);
                Assert.AreEqual(before + 10L * (4 * SurfaceBlocks.SamplesPerBlock + 4 + 16), blocks.Bytes);
                Assert.Throws<System.ArgumentOutOfRangeException>(() => blocks.Reserve(new Vector3Int(64, 0, 7), 10));
                Assert.Throws<System.ArgumentOutOfRangeException>(() => blocks.Reserve(Vector3Int.one, 0));
                Assert.Throws<FluidDeviceException>(() => blocks.Reserve(Vector3Int.one, int.MaxValue));
            }
        }

        // A row of blocks: 8 cells each, less the two of the ring.
        private List<uint> Mark(SurfaceBlocks blocks, int blockCount, double part, int capacity)
        {
            blocks.Reserve(new Vector3Int(8 * blockCount - 2, 1, 1), capacity);
            Assert.AreEqual(blockCount, blocks.BlockCount);
            blocks.Counters.SetData(new uint[SurfaceCounters.Slots]);
            var table = new uint[blockCount];
            var random = new System.Random(blockCount);
            var marked = new List<uint>();
            for (int i = 0; i < blockCount; i++)
            {
                if (random.NextDouble() >= part) continue;
                table[i] = uint.MaxValue;
                marked.Add((uint)i);
            }
            blocks.Table.SetData(table);
            return marked;
        }

        private uint[] List(SurfaceBlocks blocks)
        {
            var list = new ListSurfaceBlocksPass(shaders);
            GpuTest.Run(cmd =>
            {
                list.Record(cmd, blocks);
                list.RecordRound(cmd, blocks, false);
            });
            return GpuTest.Read<uint>(blocks.Counters, SurfaceCounters.Slots);
        }

        private void BeginLate(SurfaceBlocks blocks) =>
            GpuTest.Run(cmd => new ListSurfaceBlocksPass(shaders).RecordRound(cmd, blocks, true));
    }
}
