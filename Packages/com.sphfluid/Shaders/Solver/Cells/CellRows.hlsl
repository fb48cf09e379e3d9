#ifndef SPHFLUID_CELL_ROWS
#define SPHFLUID_CELL_ROWS

// Cells of side R, x fastest, with a border of one empty cell around the domain, so that the rows around a particle need no
// tests. Three cells of a row follow each other, and so do their particles: 9 rows in place of 27 cells
// (Dominguez et al., DualSPHysics). A kernel that includes this file declares "#pragma multi_compile_local _ FLUID_PERIODIC".
#include "../PeriodicAxes.hlsl"

float3 _CellOrigin;    // lower corner of the first border cell
float3 _CellsPerMetre; // 1 over the side of a cell along each axis
int3 _CellCounts;      // with the border

StructuredBuffer<uint> _CellStart; // first particle of each cell, the number of live ones, and that with those that left in the last step

int3 CellAt(float3 position)
{
    const int3 cell = int3(floor((position - _CellOrigin) * _CellsPerMetre));
    return clamp(cell, int3(1, 1, 1), _CellCounts - 2); // a particle on the upper face belongs to the last cell
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
    return _CellStart[RemovedCell()];
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

uint2 CellRun(int3 cell, uint k)
{
    const uint row = k % 9u;
    const int y = WrapCell(cell.y + int(row % 3u) - 1, _CellCounts.y, _PeriodLength.y);
    const int z = WrapCell(cell.z + int(row / 3u) - 1, _CellCounts.z, _PeriodLength.z);
    int first = cell.x - 1;
    int last = cell.x + 1;
    const int inner = _CellCounts.x - 2;
    if (_PeriodLength.x > 0.0)
    {
        const bool low = cell.x == 1;
        const bool high = cell.x == inner;
        if (k < 9u)
        {
            first = max(first, 1);
            last = min(last, inner);
        }
        else
        {
            first = low ? inner : 1;
            last = low ? inner : (high ? 1 : 0); // else none
        }
    }
    else if (k >= 9u)
    {
        last = first - 1;
    }
    const uint start = CellNumber(int3(0, y, z));
    return last < first ? uint2(0u, 0u) : uint2(_CellStart[start + uint(first)], _CellStart[start + uint(last + 1)]);
}

#else

#define CELL_RUNS 9u

uint2 CellRun(int3 cell, uint k)
{
    const uint first = CellNumber(cell + int3(-1, int(k % 3u) - 1, int(k / 3u) - 1));
    return uint2(_CellStart[first], _CellStart[first + 3u]);
}

#endif

// The one neighbour loop: every particle j of the rows around a cell, j included where position is its own.
#define FOR_EACH_NEAR(cell, j) FOR_EACH_NEAR_IF(true, cell, j)

// The same where a condition holds.
#define FOR_EACH_NEAR_IF(condition, cell, j) \
    for (uint cellRun##j = 0u; (condition) && cellRun##j < CELL_RUNS; cellRun##j++) \
        for (uint2 run##j = CellRun(cell, cellRun##j); run##j.x < run##j.y; run##j.x = run##j.y) \
            for (uint j = run##j.x; j < run##j.y; j++)

#endif
