using System;
using System.Collections.Generic;

namespace SphFluid.Tests
{
    /// <summary>The lists of neighbours as Shaders/Solver/Cells/NeighbourList.hlsl lays them out.</summary>
    internal static class ListColumns
    {
        private const uint Hides = 0x1000000u, GoesOn = 0x2000000u, Pair = 0x4000000u, Distance = 0xffffffu;

        /// <summary>The words of all particles: of each the neighbours as far as they fit.</summary>
        public static uint[] Write(IReadOnlyList<List<int>> neighbours, int length)
        {
            int blocks = (neighbours.Count + NeighbourList.Lanes - 1) / NeighbourList.Lanes;
            var words = new uint[blocks * NeighbourList.Lanes * NeighbourList.ColumnWords(length)];
            for (int id = 0; id < neighbours.Count; id++)
            {
                List<uint> column = Column(id, neighbours[id]);
                for (int n = 0; n < Math.Min(column.Count, NeighbourList.ColumnWords(length)); n++) words[Place(id, n, length)] = column[n];
            }

            return words;
        }

        /// <summary>The neighbours of a listed particle, those behind a face among them.</summary>
        public static List<int> Read(uint[] words, int id, int length)
        {
            var found = new List<int>();
            int at = 0, last = id;
            for (uint head = GoesOn; (head & GoesOn) != 0u;)
            {
                head = words[Place(id, at++, length)];
                last += (int)(head << 8) >> 8;
                if ((head & Hides) != 0u) at++;
                for (uint pair = 0u; pair < head / Pair; pair++)
                {
                    uint word = words[Place(id, at++, length)];
                    found.Add(last += (int)(word & 0xffffu));
                    if (word > 0xffffu) found.Add(last += (int)(word >> 16));
                }
            }

            return found;
        }

        // Without words of who is behind a face.
        private static List<uint> Column(int id, List<int> neighbours)
        {
            var words = new List<uint>();
            int head = -1, last = id;
            bool isHalf = false;
            foreach (int j in neighbours)
            {
                if (head < 0 || j - last < 0 || j - last > 0xffff)
                {
                    if (head >= 0) words[head] |= GoesOn;
                    head = words.Count;
                    words.Add((uint)(j - last) & Distance);
                    (last, isHalf) = (j, false);
                }

                if (isHalf) words[words.Count - 1] |= (uint)(j - last) << 16;
                else
                {
                    words.Add((uint)(j - last));
                    words[head] += Pair;
                }

                (last, isHalf) = (j, !isHalf);
            }

            return words;
        }

        private static int Place(int id, int n, int length) =>
            (id / NeighbourList.Lanes * NeighbourList.ColumnWords(length) + n) * NeighbourList.Lanes + id % NeighbourList.Lanes;
    }
}
