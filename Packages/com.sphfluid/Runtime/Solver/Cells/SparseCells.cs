using System;

namespace SphFluid
{
    /// <summary>
    /// Whether a liquid stores all cells or those with particles only, and how the latter lie in the table of the cells and in the
    /// published ranges: Shaders/Solver/Cells/SparseCells.hlsl and Shaders/GridCells.hlsl. Strips and cells with particles are no more than
    /// particles, so the room that there is for them is always enough.
    /// </summary>
    internal readonly struct SparseCells
    {
        /// <summary>Numbers of the table's head; SPARSE_HEAD and so on in SparseCells.hlsl.</summary>
        public const int Head = 8, LiveCount = 1, StripCount = 4, FilledCount = 5;

        /// <summary>Numbers of an entry, and where it has the first particle of a cell.</summary>
        public const int EntrySize = 4, Start = 2;

        // Cells of a word: 32 strips of 32.
        private const int CellsPerWord = 1024;

        // Tables of all cells take 17 MB then, and a sort goes through them: of 19,683 particles in 4.25 million cells a step takes 50 ms,
        // in a million 24, and 20 where only those with particles are stored (Standard, llvmpipe with 1 thread, 2026-11-29).
        private const int DefaultMostDense = 1 << 20;

        private SparseCells(int words) => Words = words;

        /// <summary>
        /// Most cells, border included, of which all are stored. Up to there a search finds a cell by one load where it takes three of
        /// those with particles.
        /// </summary>
        [OutlivesPlay("only tests change it, and put it back")] internal static int MostDense { get; set; } = DefaultMostDense;

        /// <summary>Words of strips; 0 where all cells are stored.</summary>
        public int Words { get; }

        /// <summary>Whether only cells with particles are stored.</summary>
        public bool AreUsed => Words > 0;

        /// <summary>How that many cells are stored.</summary>
        /// <param name="cellCount">Cells, border included.</param>
        public static SparseCells For(int cellCount) =>
            new SparseCells(cellCount > MostDense ? (int)((cellCount + (CellsPerWord - 1L)) / CellsPerWord) : 0);

        /// <summary>The first numbers of a table whose particles are all new: none of them was sorted before.</summary>
        public static uint[] HeadOf(int words, int newCount) => new[] { (uint)words, 0u, 0u, (uint)newCount };

        /// <summary>Where the entries begin in the table.</summary>
        public long EntriesBegin => Head + 2L * Words;

        /// <summary>Entries for that many particles.</summary>
        public static int Entries(int particleCount) => checked(particleCount + 1);

        /// <summary>Where the sums of the scans begin in the table, of words, of strips and of cells.</summary>
        public long SumsBegin(int particleCount) => EntriesBegin + (long)EntrySize * Entries(particleCount);

        /// <summary>Sums of the three scans.</summary>
        public int SumCount(int particleCount) => CellRows.ScanSums(Words) + 2 * CellRows.ScanSums(Entries(particleCount));

        /// <summary>Elements of the published cells.</summary>
        public long PublishedCount(int particleCount) => 1L + Words + 2L * Entries(particleCount);

        /// <summary>The first published range of a cell, and how many there may be.</summary>
        public (int First, int Count) PublishedRanges(int particleCount) =>
            (checked(1 + Words + Entries(particleCount)), Entries(particleCount));
    }
}
