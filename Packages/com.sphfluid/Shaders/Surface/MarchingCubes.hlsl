// Marching cubes (Lorensen & Cline 1987) over the grid of density factors. Included by the geometry shader and by the compute twin,
// so that both emit the same triangles. Numbering of corners and edges, and the meaning of the tables, after Bourke,
// "Polygonising a scalar field" (1994): corner c lies at ((c+1)/2 mod 2, c/2 mod 2, c/4), e.g. corner 2 at (1, 1, 0).
#ifndef SPHFLUID_MARCHING_CUBES_INCLUDED
#define SPHFLUID_MARCHING_CUBES_INCLUDED

// (cells + 1)^3 density factors, x fastest: density / rest density.
StructuredBuffer<float> _MCGrid;
// 256 edge flags, 256 rows of 16 edge numbers ending in -1, 12 pairs of corners (MarchingCubesTables.cs).
StructuredBuffer<int> _MCTables;
float4 _MCGridMinimum; // xyz: lowest corner of the domain [m], simulation space; w: cells a side
float4 _MCCellSize;    // xyz: size of a cell [m]; w: iso value

#define MC_EDGES 12
#define MC_MAX_VERTICES 15
#define MC_EDGE_FLAGS 0
#define MC_TRIANGLES 256
#define MC_EDGE_CORNERS 4352

// A vertex never lies closer than this part of an edge to the edge's ends: no zero-area triangles.
#define MC_EDGE_MARGIN 0.01
// A grid vertex on the wall of the domain counts as just outside, however dense the liquid there.
#define MC_WALL_FACTOR 0.9999

struct SurfaceVertex
{
    float3 position; // simulation space [m]
    float3 normal;   // unit length, out of the liquid
};

uint MCCells()
{
    return (uint)_MCGridMinimum.w;
}

float MCIsoValue()
{
    return _MCCellSize.w;
}

uint MCGridIndex(int3 v)
{
    uint side = MCCells() + 1;
    return ((uint)v.z * side + (uint)v.y) * side + (uint)v.x;
}

int3 MCCubeOrigin(uint cube)
{
    uint cells = MCCells();
    uint row = cube / cells;
    uint layer = row / cells;
    return int3((int)(cube - row * cells), (int)(row - layer * cells), (int)layer);
}

int3 MCCornerOffset(uint corner)
{
    return int3((int)(((corner + 1) >> 1) & 1), (int)((corner >> 1) & 1), (int)(corner >> 2));
}

// The field as marching cubes sees it: empty beyond the domain and just below the iso value on its walls, so every mesh is closed and
// liquid that stands against a wall ends at the wall (a hundredth of a cell inside it).
float MCFieldValue(int3 v)
{
    int last = (int)MCCells();
    float value = 0.0;
    if (all(v >= 0) && all(v <= last))
    {
        value = _MCGrid[MCGridIndex(v)];
        if (any(v == 0) || any(v == last))
            value = min(value, MCIsoValue() * MC_WALL_FACTOR);
    }
    return value;
}

// Central differences, (22)-(24) of the thesis with the step of two cells that they lack.
float3 MCGradient(int3 v)
{
    float3 difference = float3(
        MCFieldValue(v + int3(1, 0, 0)) - MCFieldValue(v - int3(1, 0, 0)),
        MCFieldValue(v + int3(0, 1, 0)) - MCFieldValue(v - int3(0, 1, 0)),
        MCFieldValue(v + int3(0, 0, 1)) - MCFieldValue(v - int3(0, 0, 1)));
    return difference / (2.0 * _MCCellSize.xyz);
}

// Bit c is set when corner c lies outside the liquid: value < iso value, as the thesis has it.
uint MCCubeIndex(int3 origin)
{
    uint index = 0;
    for (uint corner = 0; corner < 8; corner++)
    {
        if (MCFieldValue(origin + MCCornerOffset(corner)) < MCIsoValue())
            index |= 1u << corner;
    }
    return index;
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

// Corners of an edge, the lower one (nearer to the grid's origin) first: neighbouring cubes interpolate a shared edge alike, bit for bit.
int3 MCEdgeCorner(int3 origin, uint edge, uint end)
{
    return origin + MCCornerOffset((uint)_MCTables[MC_EDGE_CORNERS + edge * 2 + end]);
}

SurfaceVertex MCEdgeVertex(int3 origin, uint edge)
{
    int3 a = MCEdgeCorner(origin, edge, 0);
    int3 b = MCEdgeCorner(origin, edge, 1);
    float valueA = MCFieldValue(a);
    float valueB = MCFieldValue(b);
    float t = clamp((MCIsoValue() - valueA) / (valueB - valueA), MC_EDGE_MARGIN, 1.0 - MC_EDGE_MARGIN);

    SurfaceVertex surface;
    surface.position = _MCGridMinimum.xyz + _MCCellSize.xyz * lerp((float3)a, (float3)b, t);
    float3 outwards = -lerp(MCGradient(a), MCGradient(b), t);
    float squared = dot(outwards, outwards);
    float3 alongEdge = (float3)(b - a) * (valueA > valueB ? 1.0 : -1.0);
    surface.normal = squared > 0.0 ? outwards * rsqrt(squared) : alongEdge;
    return surface;
}

// A name of the edge that every cube around it shares: 3 * (index of its lower corner) + axis.
uint MCEdgeName(int3 origin, uint edge)
{
    int3 a = MCEdgeCorner(origin, edge, 0);
    int3 b = MCEdgeCorner(origin, edge, 1);
    uint axis = b.x != a.x ? 0u : (b.y != a.y ? 1u : 2u);
    return MCGridIndex(a) * 3 + axis;
}

// Three vertices a triangle: 0 where the surface misses the cube, 15 at most.
uint MCVertexCount(uint cubeIndex)
{
    uint count = 0;
    while (count < MC_MAX_VERTICES && MCTriangleEdge(cubeIndex, count) >= 0)
        count += 3;
    return count;
}

// Fills the vertex of every edge that the surface cuts (6.4.4, lines 15-20); MCTriangleEdge then names the edges of each triangle.
void Polygonise(int3 origin, uint cubeIndex, out SurfaceVertex vertexList[MC_EDGES])
{
    [unroll]
    for (uint cleared = 0; cleared < MC_EDGES; cleared++)
    {
        vertexList[cleared].position = 0.0;
        vertexList[cleared].normal = 0.0;
    }
    uint flags = MCEdgeFlags(cubeIndex);
    [loop]
    for (uint edge = 0; edge < MC_EDGES; edge++)
    {
        if ((flags & (1u << edge)) != 0)
            vertexList[edge] = MCEdgeVertex(origin, edge);
    }
}

#endif
