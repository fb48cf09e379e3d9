using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>More marked blocks than slots.</summary>
    public sealed class SlotCapacityTests
    {
        const uint Marked = uint.MaxValue;

        [TestCase(599)]
        [TestCase(256)]
        [TestCase(1)]
        public void NoBlockGetsASlotBehindTheLast(int capacity)
        {
            var cells = new Vector3Int(78, 78, 46); // 10 x 10 x 6 blocks
            using (var blocks = new SurfaceBlocks())
            {
                blocks.Reserve(cells, capacity);
                Assert.AreEqual(600, blocks.BlockCount);
                Assert.AreEqual(capacity, blocks.Capacity);
                blocks.Table.SetData(Enumerable.Repeat(Marked, 600).ToArray());
                blocks.Counters.SetData(new uint[SurfaceCounters.Slots]);
                GpuTest.Run(cmd => new ListSurfaceBlocksPass(SurfaceTestScene.LoadShaders()).Record(cmd, blocks));
                uint[] slots = GpuTest.Read<uint>(blocks.Table, 600).Where(entry => entry != Marked).OrderBy(entry => entry).ToArray();
                CollectionAssert.AreEqual(Enumerable.Range(1, capacity).Select(i => (uint)i), slots);
            }
        }
    }
}
