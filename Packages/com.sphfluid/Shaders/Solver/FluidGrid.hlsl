#ifndef SPHFLUID_FLUID_GRID
#define SPHFLUID_FLUID_GRID

// The thesis's grid (6.2): cells of side 2h, or h where 27 are searched, over the domain box, numbered x first, then y, then z.
// Along a periodic axis the cells are somewhat longer, so that they divide it evenly.
float3 _GridOrigin;
float3 _CellSize;
int3 _GridCounts;

// Position in units of cells.
float3 GridPosition(float3 position)
{
    return (position - _GridOrigin) / _CellSize;
}

uint CellIndex(int3 cell)
{
    return uint(cell.x + _GridCounts.x * (cell.y + _GridCounts.y * cell.z));
}

// A particle on the upper face belongs to the last cell.
int3 CellOfGrid(float3 position)
{
    const int3 cell = int3(floor(GridPosition(position)));
    return clamp(cell, int3(0, 0, 0), _GridCounts - 1);
}

uint CellValue(float3 position)
{
    return CellIndex(CellOfGrid(position));
}

#endif
