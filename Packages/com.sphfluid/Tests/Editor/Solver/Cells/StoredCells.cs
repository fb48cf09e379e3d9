using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A table of the cells with particles, as SparseCells.hlsl describes it, by the list of the cells that it names.</summary>
    internal sealed class StoredCells
    {
        private readonly uint[] table;
        private readonly int entries;
        private readonly List<int> cells = new List<int>();

        public StoredCells(uint[] table)
        {
            this.table = table;
            int words = (int)table[0];
            entries = 8 + 2 * words;
            int strip = 0;
            for (int word = 0; word < words; word++)
                foreach (int bit in Bits(table[8 + 2 * word]))
                {
                    foreach (int cell in Bits(table[entries + 4 * strip])) cells.Add(1024 * word + 32 * bit + cell);
                    strip++;
                }
        }

        /// <summary>First particle of a cell: that of the first cell from it on that is stored.</summary>
        public uint Start(int cell)
        {
            int at = cells.BinarySearch(cell);
            return table[entries + 4 * (at < 0 ? ~at : at) + 2];
        }

        /// <summary>The number that a stored cell has by itself.</summary>
        public int NumberOf(int stored) => (int)table[entries + 4 * stored + 3];

        internal static IEnumerable<int> Bits(uint word) => Enumerable.Range(0, 32).Where(bit => (word >> bit & 1u) != 0u);
    }

    /// <summary>Published cells of those with particles, read as it is described in GridCells.hlsl.</summary>
    internal sealed class PublishedCells
    {
        private readonly Dictionary<int, Vector2Int> ranges = new Dictionary<int, Vector2Int>();
        private readonly List<int> cells = new List<int>();
        private readonly int end;

        public PublishedCells(CellState state)
        {
            Vector2Int[] read = GpuTest.Read<Vector2Int>(state.Published.GridIndices, (int)state.Sparse.PublishedCount(state.Capacity));
            int words = read[0].x, strip = 0;
            for (int word = 0; word < words; word++)
                foreach (int bit in StoredCells.Bits((uint)read[1 + word].x))
                {
                    foreach (int cell in StoredCells.Bits((uint)read[1 + words + strip].x))
                    {
                        ranges.Add(1024 * word + 32 * bit + cell, read[read[0].y + cells.Count]);
                        cells.Add(1024 * word + 32 * bit + cell);
                    }
                    strip++;
                }
            end = read[read[0].y + cells.Count].x;
        }

        /// <summary>Particles of a cell; of one without, where the next begins, as a table of all cells has it.</summary>
        public Vector2Int Range(int cell)
        {
            if (ranges.TryGetValue(cell, out Vector2Int range)) return range;
            int next = ~cells.BinarySearch(cell);
            return (next < cells.Count ? ranges[cells[next]].x : end) * Vector2Int.one;
        }
    }
}
