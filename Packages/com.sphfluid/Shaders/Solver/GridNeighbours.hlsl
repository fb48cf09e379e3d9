#ifndef SPHFLUID_GRID_NEIGHBOURS
#define SPHFLUID_GRID_NEIGHBOURS

#include "../Gpu/FluidTypes.hlsl"
#include "FluidGrid.hlsl"
#include "../GridCells.hlsl"
#include "DomainFaces.hlsl"

StructuredBuffer<Particle> _Particles;
StructuredBuffer<uint2> _GridIndices; // [first, end) of each cell in _Particles: GridCells.hlsl
float _SmoothLengthSquared;           // h^2, h the support radius
float _DensityCoefficient;            // m 315 / (64 pi h^9)

SPHFLUID_CELL_RANGE(CellRange, _GridIndices)

int _CellsOfH; // 1: cells are h wide and the 27 around a particle are searched; 0: 2h wide, and eight are

// A kernel that includes this file declares "#pragma multi_compile_local _ FLUID_PERIODIC" or defines FLUID_PERIODIC (DomainFaces.hlsl).

// Along periodic axes the cell beyond the last is the first. Cells are one to two beyond the grid at most.
int3 WrapCell(int3 cell)
{
#if defined(FLUID_PERIODIC)
    const int3 wrapped = cell < 0 ? cell + _GridCounts : (cell < _GridCounts ? cell : cell - _GridCounts);
    cell = _PeriodLength > 0.0 ? wrapped : cell;
#endif
    return cell;
}

// Cells h wide: whatever is in reach lies in the 27 around the particle. Three of a row follow each other in the order of
// the cells, so their particles are one run: 9 runs. Worked example: in a row, [4, 6) [0, 0) [6, 9) make [4, 9).
// Where x is periodic, a row at its end goes on at its beginning: a second run for each. Worked example: 5 cells, x = 0:
// cells 0 and 1, then cell 4; x = 4: cells 3 and 4, then cell 0. Of three cells or more none is visited twice.
// Cells 2h wide are GetNeighbors(GetQuadrant(position)), thesis 6.3.1: h reaches over one face an axis, the nearer one. Eight runs of a
// cell each, the ninth empty. Worked example on one axis, in cells: 4.3 lies in the lower half of cell 4, floor(4.3 - 0.5) = 3, cells 3 and
// 4; 4.7 lies in the upper half, floor(4.7 - 0.5) = 4, cells 4 and 5.
uint NeighbourRanges(float3 position)
{
#if defined(FLUID_PERIODIC)
    const int x = int(floor(GridPosition(position).x));
    return _CellsOfH != 0 && _PeriodLength.x > 0.0 && (x < 1 || x + 1 >= _GridCounts.x) ? 18u : 9u;
#else
    return 9u;
#endif
}

// Cells from first to last of a row along x.
struct CellSpan
{
    int first;
    int last;
    int2 row; // y, z
};

CellSpan RunOfThree(float3 position, uint k)
{
    const uint row = k % 9u;
    const int3 cell = int3(floor(GridPosition(position))) + int3(0, int(row % 3u) - 1, int(row / 3u) - 1);
    CellSpan run;
    run.first = max(cell.x - 1, 0);
    run.last = min(cell.x + 1, _GridCounts.x - 1);
    run.row = WrapCell(cell).yz;
#if defined(FLUID_PERIODIC)
    const int first = cell.x < 1 ? _GridCounts.x + cell.x - 1 : 0;
    const int last = cell.x < 1 ? _GridCounts.x - 1 : cell.x + 1 - _GridCounts.x;
    run.first = k < 9u ? run.first : first;
    run.last = k < 9u ? run.last : last;
#endif
    return run;
}

CellSpan RunOfOne(float3 position, uint k)
{
    const int3 cell = WrapCell(int3(floor(GridPosition(position) - 0.5)) + int3(uint3(k, k >> 1, k >> 2) & 1u));
    const bool exists = k < 8u && cell.x >= 0 && cell.x < _GridCounts.x;
    CellSpan run;
    run.first = exists ? cell.x : 0;
    run.last = exists ? cell.x : -1;
    run.row = cell.yz;
    return run;
}

// Particles of the k-th run.
uint2 NeighbourRange(float3 position, uint k)
{
    const CellSpan three = RunOfThree(position, k);
    const CellSpan one = RunOfOne(position, k);
    const int first = _CellsOfH != 0 ? three.first : one.first;
    const int last = _CellsOfH != 0 ? three.last : one.last;
    const int2 row = _CellsOfH != 0 ? three.row : one.row;
    uint2 particles = uint2(0xffffffffu, 0u);
    if (all(row >= 0) && all(row < _GridCounts.yz))
    {
        for (int x = first; x <= last; x++)
        {
            const uint2 range = CellRange(int3(x, row), _GridCounts);
            particles.x = range.x < range.y ? min(particles.x, range.x) : particles.x; // an empty cell has no first
            particles.y = max(particles.y, range.y);
        }
    }
    return particles;
}

// The one neighbour loop: every particle j of the neighbour cells, j included where position is its own.
// Whether j is in reach of h is the body's question: it has the distance, by Separation.
#define FOR_EACH_NEIGHBOUR(position, j) FOR_EACH_NEIGHBOUR_IF(true, position, j)

// The same where a condition holds.
#define FOR_EACH_NEIGHBOUR_IF(condition, position, j) \
    for (uint neighbourRange = 0u; (condition) && neighbourRange < NeighbourRanges(position); neighbourRange++) \
        for (uint2 range = NeighbourRange(position, neighbourRange); range.x < range.y; range.x = range.y) \
            for (uint j = range.x; j < range.y; j++)

// The thesis's DFact for one pair: (h^2 - r^2)^3, equation (12) without its factor.
float DensityFactor(float distanceSquared)
{
    const float t = max(_SmoothLengthSquared - distanceSquared, 0.0);
    return t * t * t;
}

// Density [kg/m^3] at any point, equation (11). Step 6.4.3 evaluates it at the marching-cubes vertices.
float ThesisDensityAt(float3 position)
{
    float sum = 0.0;
    FOR_EACH_NEIGHBOUR(position, j)
    {
        const float3 d = Separation(position, _Particles[j].Position);
        sum += DensityFactor(dot(d, d));
    }
    return sum * _DensityCoefficient;
}

#endif
