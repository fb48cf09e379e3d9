#ifndef SPHFLUID_CELL_SUMS
#define SPHFLUID_CELL_SUMS

#include "CellRows.hlsl"

// Threads of a group of the scan, cells that a thread sums, and parts of a group's sum; mirrored by CellRows.cs.
#define SCAN_THREADS 256
#define SCAN_CELLS_PER_THREAD 8
#define SCAN_SUM_PARTS 16
#define SCAN_CELLS_PER_GROUP (SCAN_THREADS * SCAN_CELLS_PER_THREAD)

// In the table of the cells: counts of the cells and of those that left the domain, then the sums of the scan's groups of cells, as
// SCAN_SUM_PARTS parts each: lanes that count into cells of one group do not wait for one address. Integers, so the order of the counts
// does not matter.
uint _CellCountBegin;
uint _RankBegin; // behind them the place of each particle in its cell

// Counts a particle in a cell; how many were counted there before it. Where the table has no empty cells RankCells counts, by itself.
uint CountCell(uint cell, uint id)
{
    uint rank = 0u;
    [branch]
    if (_CellTableOut[SPARSE_WORDS] == 0u)
    {
        const uint sum = RemovedCell() + 1u + cell / SCAN_CELLS_PER_GROUP * SCAN_SUM_PARTS + id % SCAN_SUM_PARTS;
        uint ignored;
        InterlockedAdd(_CellTableOut[_CellCountBegin + sum], 1u, ignored);
        InterlockedAdd(_CellTableOut[_CellCountBegin + cell], 1u, rank);
    }
    return rank;
}

#endif
