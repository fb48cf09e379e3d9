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
#define MC_ALL_OUTSIDE 255u // index of a cube without a vertex inside

// A vertex never lies closer than this part of an edge to the edge's ends: no zero-area triangles.
#define MC_EDGE_MARGIN 0.01
// Thickness, in cells, of the ring of cubes that closes the mesh at the walls of the domain.
#define MC_RING 0.02

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

// Cubes a side: those of the grid and the ring around them, whose outer vertices -1 and cells + 1 lie in empty space.
uint MCCubes()
{
    return MCCells() + 2;
}

int3 MCCubeOrigin(uint cube)
{
    uint side = MCCubes();
    uint row = cube / side;
    uint layer = row / side;
    return int3((int)(cube - row * side), (int)(row - layer * side), (int)layer) - 1;
}

int3 MCCornerOffset(uint corner)
{
    return int3((int)(((corner + 1) >> 1) & 1), (int)((corner >> 1) & 1), (int)(corner >> 2));
}

bool MCInGrid(int3 v)
{
    return all(v >= 0) && all(v <= (int)MCCells());
}

float MCFieldValue(int3 v)
{
    float value = 0.0;
    if (MCInGrid(v))
    {
        uint side = MCCells() + 1;
        value = _MCGrid[((uint)v.z * side + (uint)v.y) * side + (uint)v.x];
    }
    return value;
}

// The ring is squeezed against the wall from inside: liquid that touches a wall ends there, with a sharp edge. Of 64 cells the vertices
// -1, 0, 1 ... 63, 64, 65 lie at 0, 0.02, 1 ... 63, 63.98, 64.
float3 MCGridPosition(int3 v)
{
    float cells = (float)MCCells();
    float3 position = clamp((float3)v, MC_RING, cells - MC_RING);
    position = v < 0 ? (float3)0.0 : position;
    return v > (int)MCCells() ? (float3)cells : position;
}

// Central differences, (22)-(24) of the thesis with the step of two cells that they lack; one-sided on the walls.
float3 MCGradient(int3 v)
{
    int3 upper = min(v + 1, (int)MCCells());
    int3 lower = max(v - 1, 0);
    float3 difference = float3(
        MCFieldValue(int3(upper.x, v.y, v.z)) - MCFieldValue(int3(lower.x, v.y, v.z)),
        MCFieldValue(int3(v.x, upper.y, v.z)) - MCFieldValue(int3(v.x, lower.y, v.z)),
        MCFieldValue(int3(v.x, v.y, upper.z)) - MCFieldValue(int3(v.x, v.y, lower.z)));
    return difference / ((float3)(upper - lower) * _MCCellSize.xyz);
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

// Out of the liquid: against the gradient within the grid, straight through the wall in the ring.
float3 MCEdgeNormal(int3 a, int3 b, float t, float3 alongEdge)
{
    float3 outwards = 0.0;
    if (MCInGrid(a) && MCInGrid(b))
        outwards = -lerp(MCGradient(a), MCGradient(b), t);
    float squared = dot(outwards, outwards);
    return squared > 0.0 ? outwards * rsqrt(squared) : alongEdge;
}

SurfaceVertex MCEdgeVertex(int3 origin, uint edge)
{
    int3 a = MCEdgeCorner(origin, edge, 0);
    int3 b = MCEdgeCorner(origin, edge, 1);
    float valueA = MCFieldValue(a);
    float valueB = MCFieldValue(b);
    float t = clamp((MCIsoValue() - valueA) / (valueB - valueA), MC_EDGE_MARGIN, 1.0 - MC_EDGE_MARGIN);

    SurfaceVertex surface;
    surface.position = _MCGridMinimum.xyz + _MCCellSize.xyz * lerp(MCGridPosition(a), MCGridPosition(b), t);
    surface.normal = MCEdgeNormal(a, b, t, (float3)(b - a) * (valueA > valueB ? 1.0 : -1.0));
    return surface;
}

// A name of the edge that every cube around it shares: 3 * (number of its lower corner, the ring's included) + axis.
uint MCEdgeName(int3 origin, uint edge)
{
    uint3 a = (uint3)(MCEdgeCorner(origin, edge, 0) + 1);
    uint3 b = (uint3)(MCEdgeCorner(origin, edge, 1) + 1);
    uint axis = b.x != a.x ? 0u : (b.y != a.y ? 1u : 2u);
    uint side = MCCubes() + 1;
    return ((a.z * side + a.y) * side + a.x) * 3 + axis;
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
