#ifndef SPHFLUID_THESIS_NEIGHBOURS
#define SPHFLUID_THESIS_NEIGHBOURS

#include "../Gpu/FluidTypes.hlsl"
#include "FluidGrid.hlsl"

StructuredBuffer<Particle> _Particles;
StructuredBuffer<uint2> _GridIndices; // [first, end) of each cell in _Particles
int _OctantSearch;                    // 1: the 8 cells of the octant, 0: all 27
float _SmoothLengthSquared;           // h^2, h the support radius
float _DensityCoefficient;            // m 315 / (64 pi h^9)

#define NEIGHBOUR_CELLS (_OctantSearch != 0 ? 8u : 27u)

// GetNeighbors(GetQuadrant(position)), thesis 6.3.1. A cell is 2h wide, so h reaches over one face an axis: the nearer one.
// Worked example on one axis, in cells: 4.3 lies in the lower half of cell 4, floor(4.3 - 0.5) = 3, cells 3 and 4;
// 4.7 lies in the upper half, floor(4.7 - 0.5) = 4, cells 4 and 5.
int3 NeighbourCell(float3 position, uint k)
{
    const float3 p = GridPosition(position);
    if (_OctantSearch != 0)
    {
        return int3(floor(p - 0.5)) + int3(uint3(k, k >> 1, k >> 2) & 1u);
    }
    return int3(floor(p)) - 1 + int3(uint3(k, k / 3u, k / 9u) % 3u);
}

// Particles of the k-th neighbour cell; cells outside the grid hold none.
uint2 NeighbourRange(float3 position, uint k)
{
    const int3 cell = NeighbourCell(position, k);
    uint2 range = uint2(0u, 0u);
    if (all(cell >= 0) && all(cell < _GridCounts))
    {
        range = _GridIndices[CellIndex(cell)];
    }
    return range;
}

// The one neighbour loop: every particle j of the neighbour cells, j included where position is its own.
// Whether j is in reach of h is the body's question: it has the distance.
#define FOR_EACH_NEIGHBOUR(position, j) \
    for (uint neighbourCell = 0u; neighbourCell < NEIGHBOUR_CELLS; neighbourCell++) \
        for (uint2 range = NeighbourRange(position, neighbourCell); range.x < range.y; range.x = range.y) \
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
        const float3 d = position - _Particles[j].Position;
        sum += DensityFactor(dot(d, d));
    }
    return sum * _DensityCoefficient;
}

#endif
