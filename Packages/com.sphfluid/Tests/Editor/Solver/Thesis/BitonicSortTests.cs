using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Appendix A at sizes around its blocks (1,024), tiles (32 × 1,024) and matrix (1,024 × 1,024).</summary>
    public sealed class BitonicSortTests
    {
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
        [TestCase(131071)]
        public void ResultIsTheSamePairsInOrder(int count)
        {
            CheckSort(RandomPairs(count, Math.Max(1, count / 8)));
        }

        [Test]
        public void ColumnsLongerThanABlock()
        {
            CheckSort(RandomPairs(2 * 1024 * 1024, 300000));
        }

        [TestCase(0)]
        [TestCase(1)]
        [TestCase(2)]
        [TestCase(511)]
        [TestCase(512)]
        [TestCase(513)]
        [TestCase(1023)]
        [TestCase(1024)]
        [TestCase(1025)]
        [TestCase(2053)]
        [TestCase(5003)]
        [TestCase(65536)]
        [TestCase(65537)]
        public void FusedLevelsGiveTheSamePairsInOrder(int count)
        {
            CheckSort(RandomPairs(count, Math.Max(1, count / 8)), fused: true);
        }

        // Equal pairs do not occur in a liquid; which of them ends where would show another order of comparisons.
        [TestCase(1024)]
        [TestCase(8192)]
        public void FusedLevelsMakeTheSameExchanges(int count)
        {
            ulong[] pairs = RandomPairs(count, 5).Select(p => p & ~0xFFFFFFFFul | (p & 3ul)).ToArray();
            Assert.That(Sort(pairs, count, fused: true), Is.EqualTo(Sort(pairs, count, fused: false)));
        }

        [TestCase(0)]
        [TestCase(1)]
        [TestCase(2)]
        public void OrderedReversedAndEqualCells(int kind)
        {
            ulong[] pairs = RandomPairs(5003, 5003);
            for (uint i = 0; i < pairs.Length; i++)
            {
                ulong cell = kind == 0 ? i : kind == 1 ? (ulong)(pairs.Length - i) : 7u;
                pairs[i] = Pair((uint)cell, i);
            }

            CheckSort(pairs);
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

        static void CheckSort(ulong[] pairs, bool fused = false)
        {
            int padded = BitonicSortPass.PaddedCount(pairs.Length);
            ulong[] input = pairs.Concat(Enumerable.Range(pairs.Length, padded - pairs.Length)
                .Select(i => Pair(uint.MaxValue, (uint)i))).ToArray();
            ulong[] output = Sort(input, padded, fused);

            // Pairs are unique and their order total: in order and a permutation means equal to the sorted input.
            Array.Sort(input);
            Assert.That(Enumerable.SequenceEqual(output, input), Is.True, $"{pairs.Length} pairs");
        }

        static ulong[] Sort(ulong[] pairs, int padded, bool fused)
        {
            FluidShaderSet shaders = TestShaders.CreateSet();
            using (GraphicsBuffer data = GpuBuffers.Create("Data", padded, 8))
            using (GraphicsBuffer temp = GpuBuffers.Create("Temp", padded, 8))
            {
                data.SetData(pairs.SelectMany(p => new[] { (uint)(p >> 32), (uint)p }).ToArray());
                var sort = new BitonicSortPass(shaders);
                GpuTest.Run(cmd => sort.Record(cmd, data, temp, padded, fused));
                uint[] raw = GpuTest.Read<uint>(data, 2 * padded);
                UnityEngine.Object.DestroyImmediate(shaders);
                return Enumerable.Range(0, padded).Select(i => Pair(raw[2 * i], raw[2 * i + 1])).ToArray();
            }
        }

        static ulong[] RandomPairs(int count, int cells)
        {
            var random = new System.Random(count + 1);
            return Enumerable.Range(0, count).Select(i => Pair((uint)random.Next(cells), (uint)i)).ToArray();
        }

        static ulong Pair(uint cell, uint id) => (ulong)cell << 32 | id;
    }
}
