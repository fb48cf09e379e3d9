// The tables of marching cubes. Numbering of corners and edges after Bourke, "Polygonising a scalar field" (1994):
// corner c lies at ((c+1)/2 mod 2, c/2 mod 2, c/4), e.g. corner 2 at (1, 1, 0).
#ifndef SPHFLUID_MARCHING_CUBES_TABLES_INCLUDED
#define SPHFLUID_MARCHING_CUBES_TABLES_INCLUDED

// 256 edge flags, 256 rows of 16 edge numbers ending in -1, 12 pairs of corners, 256 row lengths
// (MarchingCubesTables.cs).
StructuredBuffer<int> _MCTables;

#define MC_EDGES 12
#define MC_MAX_VERTICES 15
#define MC_EDGE_FLAGS 0
#define MC_TRIANGLES 256
#define MC_EDGE_CORNERS 4352
#define MC_VERTEX_COUNTS 4376
#define MC_ALL_OUTSIDE 255u // index of a cube without a vertex inside

int3 MCCornerOffset(uint corner)
{
    return int3((int)(((corner + 1) >> 1) & 1), (int)((corner >> 1) & 1), (int)(corner >> 2));
}

uint MCEdgeFlags(uint cubeIndex)
{
    return (uint)_MCTables[MC_EDGE_FLAGS + cubeIndex];
}

// The edge that holds the slot-th vertex of the cube's triangles, or -1 behind the last.
int MCTriangleEdge(uint cubeIndex, uint slot)
{
    return _MCTables[MC_TRIANGLES + cubeIndex * 16 + slot];
}

// Corners of an edge, the lower one (nearer to the grid's origin) first: neighbouring cubes interpolate a shared edge
// alike, bit for bit.
int3 MCEdgeCorner(int3 origin, uint edge, uint end)
{
    return origin + MCCornerOffset((uint)_MCTables[MC_EDGE_CORNERS + edge * 2 + end]);
}

// Edges 0, 2, 4, 6 of a cube run along x, 1, 3, 5, 7 along y, 8 to 11 along z.
uint MCEdgeAxis(uint edge)
{
    return edge < 8u ? edge & 1u : 2u;
}

// Three vertices a triangle: 0 where the surface misses the cube, 15 at most.
uint MCVertexCount(uint cubeIndex)
{
    return (uint)_MCTables[MC_VERTEX_COUNTS + cubeIndex];
}

#endif
