#ifndef SPHFLUID_CELL_ROWS
#define SPHFLUID_CELL_ROWS

// Cells of side R, x fastest, with a border of one empty cell around the domain, so that the rows around a particle need no
// tests. Three cells of a row follow each other, and so do their particles: 9 rows in place of 27 cells
// (Dominguez et al., DualSPHysics). A kernel that includes this file declares "#pragma multi_compile_local _ FLUID_PERIODIC".
#include "../DomainFaces.hlsl"

// Threads of a group that walks over neighbours: small groups spread few particles over many processors.
#define CELL_THREADS 64

// Groups a dispatch may have in one dimension (Direct3D 11, Vulkan, Metal).
#define CELL_MAX_GROUPS 65535

float3 _CellOrigin;    // lower corner of the first border cell
float3 _CellsPerMetre; // 1 over the side of a cell along each axis
int4 _CellCounts;      // with the border; w: where the table has the number of live particles

// The first particle of each cell, the number of live ones, and that with those that left in the last step; behind them what the next
// sort needs (CellSums.hlsl). A kernel that counts for it defines COUNTS_CELLS and reads the table where it writes.
// Where the domain has too many cells the table has those with particles only: SparseCells.hlsl.
StructuredBuffer<uint> _CellTable;
RWStructuredBuffer<uint> _CellTableOut;

#if defined(COUNTS_CELLS)
#define CELL_TABLE _CellTableOut
#else
#define CELL_TABLE _CellTable
#endif

#include "SparseCells.hlsl"

// Which table it is: 0, one of all cells. The number lies in the table: Mesa may translate a kernel anew for each value of a uniform that
// it branches on.
uint TableWords()
{
    return CELL_TABLE[SPARSE_WORDS];
}

// Where two cells begin.
uint2 CellStarts(uint words, uint first, uint second)
{
    uint2 starts;
    [branch]
    if (words == 0u)
    {
        starts = uint2(CELL_TABLE[first], CELL_TABLE[second]);
    }
    else
    {
        starts = uint2(SparseStart(words, first), SparseStart(words, second));
    }
    return starts;
}

uint CellStart(uint cell)
{
    return CellStarts(TableWords(), cell, cell).x;
}

// Particle of a thread: positions and velocities lie in float4 apart, one aligned load each; a velocity's w is the id.
uint ParticleIndex(uint3 groupId, uint groupIndex)
{
    return (groupId.y * CELL_MAX_GROUPS + groupId.x) * CELL_THREADS + groupIndex;
}

int3 CellAt(float3 position)
{
    const int3 cell = int3(floor((position - _CellOrigin) * _CellsPerMetre));
    return clamp(cell, int3(1, 1, 1), _CellCounts.xyz - 2); // a particle on the upper face belongs to the last cell
}

uint CellNumber(int3 cell)
{
    return uint(cell.x + _CellCounts.x * (cell.y + _CellCounts.y * cell.z));
}

// Particles that leave are counted as if in a cell after the last.
uint RemovedCell()
{
    return uint(_CellCounts.x * _CellCounts.y * _CellCounts.z);
}

// Live particles: the first of the sorted ones. What stands behind them is undefined.
uint LiveCount()
{
    return CELL_TABLE[uint(_CellCounts.w)];
}

// Those, and those that left in the last step.
uint CountedCount()
{
    return CELL_TABLE[uint(_CellCounts.w) + 1u];
}

// The number of the cell that a live particle was sorted into, where that is asked: the last that begins with it or
// before. Empty cells begin where the next does. Worked example, cells that begin at 0, 0, 2 and 5: particle 1 is in the second.
uint SortedCell(uint id, bool isAsked)
{
    const uint words = isAsked ? TableWords() : 0u;
    const bool isSparse = words != 0u;
    const uint begin = isSparse ? SparseEntry(words, 0u) + SPARSE_START : 0u;
    const uint shift = isSparse ? SPARSE_ENTRY : 0u;
    uint cell = 0u;
    uint end = isSparse ? CELL_TABLE[SPARSE_CELLS] : isAsked ? RemovedCell() : 0u;
    while (end > cell + 1u)
    {
        const uint middle = (cell + end) / 2u;
        const bool begins = CELL_TABLE[begin + (middle << shift)] <= id;
        cell = begins ? middle : cell;
        end = begins ? end : middle;
    }
    const uint number = CELL_TABLE[isSparse ? SparseEntry(words, cell) + SPARSE_NUMBER : 0u];
    return isSparse ? number : cell;
}

int3 CellOf(uint number)
{
    const uint3 counts = uint3(_CellCounts.xyz);
    return int3(uint3(number % counts.x, number / counts.x % counts.y, number / (counts.x * counts.y)));
}

#if defined(FLUID_PERIODIC)

// Along a periodic axis the row continues behind the opposite face: a row of three cells is then two runs.
#define CELL_RUNS 18u

int WrapCell(int cell, int count, float length)
{
    const int inner = count - 2;
    const int wrapped = cell < 1 ? cell + inner : (cell > inner ? cell - inner : cell);
    return length > 0.0 ? wrapped : cell;
}

uint2 CellRun(uint words, int3 cell, uint k)
{
    const uint row = k % 9u;
    const int y = WrapCell(cell.y + int(row % 3u) - 1, _CellCounts.y, _PeriodLength.y);
    const int z = WrapCell(cell.z + int(row / 3u) - 1, _CellCounts.z, _PeriodLength.z);
    const int inner = _CellCounts.x - 2;
    const bool low = _PeriodLength.x > 0.0 && cell.x == 1;
    const bool high = _PeriodLength.x > 0.0 && cell.x == inner;
    const int first = k < 9u ? cell.x - (low ? 0 : 1) : low ? inner : 1;
    const int last = k < 9u ? cell.x + (high ? 0 : 1) : low || high ? first : 0; // else none
    const uint start = CellNumber(int3(0, y, z));
    return last < first ? uint2(0u, 0u) : CellStarts(words, start + uint(first), start + uint(last + 1));
}

#else

#define CELL_RUNS 9u

uint2 CellRun(uint words, int3 cell, uint k)
{
    const uint first = CellNumber(cell + int3(-1, int(k % 3u) - 1, int(k / 3u) - 1));
    return CellStarts(words, first, first + 3u);
}

#endif

// Where a condition holds, every particle j of the rows around a cell.
#define FOR_EACH_NEAR_IF(condition, cell, j) \
    for (uint cellRun##j = 0u, words##j = TableWords(); (condition) && cellRun##j < CELL_RUNS; cellRun##j++) \
        for (uint2 run##j = CellRun(words##j, cell, cellRun##j); run##j.x < run##j.y; run##j.x = run##j.y) \
            for (uint j = run##j.x; j < run##j.y; j++)

#endif
