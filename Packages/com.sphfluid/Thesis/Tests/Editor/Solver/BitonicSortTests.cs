using System;
using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>Appendix A at sizes around its blocks (1,024), tiles (32 × 1,024) and matrix (1,024 × 1,024).</summary>
    public sealed class BitonicSortTests
    {
        private FluidShaderSet shaders;

        [SetUp]
        public void CreateShaders() => shaders = TestShaders.CreateSet();

        [TearDown]
        public void DestroyShaders() => UnityEngine.Object.DestroyImmediate(shaders);

        [TestCase(0)]
        [TestCase(1)]
        [TestCase(2)]
        [TestCase(1023)]
        [TestCase(1024)]
        [TestCase(1025)]
        [TestCase(4096)]
        [TestCase(5003)]
        [TestCase(16384)]
        [TestCase(32768)]
        [TestCase(32769)]
        [TestCase(65536)]
        public void ResultIsTheSamePairsInOrder(int count)
        {
            CheckSort(SortPairs.Random(count, Math.Max(1, count / 8)));
        }

        [Test]
        public void ColumnsLongerThanABlock()
        {
            // The last level alone, of halves that go up and down.
            const int Count = 2 * BitonicSortPass.BlockSize * BitonicSortPass.BlockSize;
            ulong[] pairs = SortPairs.Random(Count, 300000);
            Array.Sort(pairs, 0, Count / 2);
            Array.Sort(pairs, Count / 2, Count / 2);
            Array.Reverse(pairs, Count / 2, Count / 2);
            var sort = new BitonicSortPass(shaders);
            SortPairs.Check(pairs, (cmd, data, temp, count) => sort.RecordLevel(cmd, data, temp, Count, count));
        }

        [Test]
        public void OrderedReversedAndEqualCells()
        {
            CheckSort(SortPairs.Cells(5003, i => i));
            CheckSort(SortPairs.Cells(5003, i => 5003 - i));
            CheckSort(SortPairs.Cells(5003, i => 7));
        }

        [TestCase(0, 1024)]
        [TestCase(1024, 1024)]
        [TestCase(1025, 2048)]
        [TestCase(5003, 8192)]
        [TestCase(1 << 30, 1 << 30)]
        public void PaddedToAPowerOfTwo(int count, int padded)
        {
            Assert.That(BitonicSortPass.PaddedCount(count), Is.EqualTo(padded));
        }

        [Test]
        public void MoreThanTheSortCanIndexIsAnError()
        {
            Assert.Throws<FluidDeviceException>(() => BitonicSortPass.PaddedCount((1 << 30) + 1));
        }

        private void CheckSort(ulong[] pairs)
        {
            var sort = new BitonicSortPass(shaders);
            SortPairs.Check(pairs, (cmd, data, temp, count) => sort.Record(cmd, data, temp, count));
        }
    }
}
