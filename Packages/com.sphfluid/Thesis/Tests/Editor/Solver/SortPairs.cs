using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Tests
{
    /// <summary>Pairs (cell, id) as one number each, and a check of a pass that sorts them.</summary>
    internal static class SortPairs
    {
        public static ulong Of(uint cell, uint id) => (ulong)cell << 32 | id;

        /// <summary>Pairs with ids in order and cells at random.</summary>
        public static ulong[] Random(int count, int cells)
        {
            var random = new System.Random(count + 1);
            return Enumerable.Range(0, count).Select(i => Of((uint)random.Next(cells), (uint)i)).ToArray();
        }

        /// <summary>Pairs with ids in order, whose cells are a function of the place.</summary>
        public static ulong[] Cells(int count, Func<int, int> cell) =>
            Enumerable.Range(0, count).Select(i => Of((uint)cell(i), (uint)i)).ToArray();

        /// <summary>Sorts the pairs, padded as the cells of particles are, and compares with the order that .NET finds.</summary>
        /// <param name="pairs">Unique pairs.</param>
        /// <param name="record">Records the sort of data with temp and the padded number.</param>
        public static void Check(ulong[] pairs, Action<CommandBuffer, GraphicsBuffer, GraphicsBuffer, int> record)
        {
            int padded = BitonicSortPass.PaddedCount(pairs.Length);
            ulong[] input = pairs.Concat(Enumerable.Range(pairs.Length, padded - pairs.Length).Select(i => Of(uint.MaxValue, (uint)i)))
                .ToArray();
            using (GraphicsBuffer data = GpuBuffers.Create("Data", padded, 8))
            using (GraphicsBuffer temp = GpuBuffers.Create("Temp", padded, 8))
            {
                data.SetData(input.SelectMany(p => new[] { (uint)(p >> 32), (uint)p }).ToArray());
                GpuTest.Run(cmd => record(cmd, data, temp, padded));
                uint[] raw = GpuTest.Read<uint>(data, 2 * padded);
                ulong[] output = Enumerable.Range(0, padded).Select(i => Of(raw[2 * i], raw[2 * i + 1])).ToArray();

                // Pairs are unique and their order total: there is one right answer.
                Array.Sort(input);
                Assert.That(output.SequenceEqual(input), Is.True, $"{pairs.Length} pairs");
            }
        }
    }
}
