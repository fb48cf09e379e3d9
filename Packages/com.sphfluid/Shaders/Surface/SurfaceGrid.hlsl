// The marching-cubes grid (SurfaceGrid.cs). Grid vertices run from 0 to cells along an axis; the ring adds -1 and cells
// + 1, which lie in empty space. Cubes are named by their lowest vertex: -1 to cells.
#ifndef SPHFLUID_SURFACE_GRID_INCLUDED
#define SPHFLUID_SURFACE_GRID_INCLUDED

float3 _MCMinimum;  // lowest corner of the domain [m], simulation space
float3 _MCCellSize; // [m]
float3 _MCCells;    // cells along each axis; whole numbers as floats, because materials set no vectors of integers
float _MCRing;      // thickness, in cells, of the ring of cubes that closes the mesh at the walls; 0: the mesh ends there
float _MCIsoValue;  // of the surface; a vertex with this value or more lies inside the liquid

int3 MCCells()
{
    return (int3)_MCCells;
}

// Cubes along each axis, the ring's included.
uint3 MCCubes()
{
    return (uint3)MCCells() + 2u;
}

// Lowest vertex of the cube with this number; cubes are numbered x first.
int3 MCCubeOrigin(uint cube)
{
    uint3 cubes = MCCubes();
    uint row = cube / cubes.x;
    uint layer = row / cubes.y;
    return int3((int)(cube - row * cubes.x), (int)(row - layer * cubes.y), (int)layer) - 1;
}

// Grid vertices along each axis, without the ring.
uint3 MCGridVertices()
{
    return (uint3)MCCells() + 1u;
}

// Number of a grid vertex, x first.
uint MCVertexIndex(uint3 v)
{
    uint3 side = MCGridVertices();
    return (v.z * side.y + v.y) * side.x + v.x;
}

// Below 0 is far above as an unsigned number.
bool MCInGrid(int3 v)
{
    return all((uint3)v <= (uint3)MCCells());
}

// The ring is squeezed against the wall from inside: liquid that touches a wall ends there, with a sharp edge. Of 64
// cells the vertices
// -1, 0, 1 ... 63, 64, 65 lie at 0, 0.02, 1 ... 63, 63.98, 64.
float3 MCGridPosition(int3 v)
{
    float3 position = clamp((float3)v, _MCRing, _MCCells - _MCRing);
    position = v < 0 ? (float3)0.0 : position;
    return v > MCCells() ? _MCCells : position;
}

// From cells to simulation space [m].
float3 MCPosition(float3 gridPosition)
{
    return _MCMinimum + _MCCellSize * gridPosition;
}

// A name of the grid edge that starts at a vertex, the ring's included, and runs along an axis: 3 x number of the
// vertex + axis.
uint MCEdgeNameAt(int3 lower, uint axis)
{
    uint3 v = (uint3)(lower + 1);
    uint3 side = MCCubes() + 1u;
    return ((v.z * side.y + v.y) * side.x + v.x) * 3u + axis;
}

#endif
