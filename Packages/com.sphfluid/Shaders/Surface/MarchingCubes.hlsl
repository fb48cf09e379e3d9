// Marching cubes (Lorensen & Cline 1987) over the grid of density factors. Included by the geometry shader, by its
// compute twin and by the sparse surface, so that all make the same triangles. The including file declares before where
// field values come from, e.g. by Thesis/DenseField.hlsl:
//     float MCFieldValue(int3 v)  0 outside the grid
//     int3 MCKnownAbove(int3 v)   along each axis the next higher vertex of the grid, or the own one where its value is
// not known: for gradients
//     int3 MCKnownBelow(int3 v)   the same for the next lower one
//     float MCKnownValue(int3 v)  the value of such a vertex
#ifndef SPHFLUID_MARCHING_CUBES_INCLUDED
#define SPHFLUID_MARCHING_CUBES_INCLUDED

#include "SurfaceGrid.hlsl"
#include "SurfaceVertex.hlsl"
#include "MarchingCubesTables.hlsl"

// A vertex never lies closer than this part of an edge to the edge's ends: no zero-area triangles.
#define MC_EDGE_MARGIN 0.01

// Central differences, (22)-(24) of the thesis, divided by the step of two cells, which it leaves out; one-sided on the
// walls.
float3 MCGradient(int3 v)
{
    int3 upper = MCKnownAbove(v);
    int3 lower = MCKnownBelow(v);
    float3 difference = float3(
        MCKnownValue(int3(upper.x, v.y, v.z)) - MCKnownValue(int3(lower.x, v.y, v.z)),
        MCKnownValue(int3(v.x, upper.y, v.z)) - MCKnownValue(int3(v.x, lower.y, v.z)),
        MCKnownValue(int3(v.x, v.y, upper.z)) - MCKnownValue(int3(v.x, v.y, lower.z)));
    return difference / ((float3)max(upper - lower, 1) * _MCCellSize);
}

// Bit c is set when corner c lies outside the liquid: value < iso value, as the thesis has it.
uint MCCubeIndex(int3 origin)
{
    uint index = 0;
    for (uint corner = 0; corner < 8; corner++)
    {
        if (MCFieldValue(origin + MCCornerOffset(corner)) < _MCIsoValue)
            index |= 1u << corner;
    }
    return index;
}

// Out of the liquid: against the gradient within the grid, straight through the wall in the ring.
float3 MCEdgeNormal(int3 a, int3 b, float t, float3 alongEdge)
{
    float3 outwards = 0.0;
    if (MCInGrid(a) && MCInGrid(b))
    {
        float3 first = 0.0;
        float3 second = 0.0;
        [loop]
        for (uint end = 0u; end < 2u; end++) // one copy of the gradient for the compiler
        {
            first = second;
            second = MCGradient(end == 0u ? a : b);
        }
        outwards = -lerp(first, second, t);
    }
    float squared = dot(outwards, outwards);
    return squared > 0.0 ? outwards * rsqrt(squared) : alongEdge;
}

// Where between two neighbouring grid vertices the surface passes.
float MCCrossing(float valueA, float valueB)
{
    return clamp((_MCIsoValue - valueA) / (valueB - valueA), MC_EDGE_MARGIN, 1.0 - MC_EDGE_MARGIN);
}

// The surface's vertex between two neighbouring grid vertices, the lower one first.
SurfaceVertex MCVertexBetween(int3 a, int3 b)
{
    float valueA = MCFieldValue(a);
    float valueB = MCFieldValue(b);
    float t = MCCrossing(valueA, valueB);
    float3 start = MCGridPosition(a);

    SurfaceVertex surface;
    surface.position = MCPosition(start + t * (MCGridPosition(b) - start)); // exactly on the edge, other than by lerp on some devices
    surface.normal = MCEdgeNormal(a, b, t, (float3)(b - a) * (valueA > valueB ? 1.0 : -1.0));
    return surface;
}

SurfaceVertex MCEdgeVertex(int3 origin, uint edge)
{
    return MCVertexBetween(MCEdgeCorner(origin, edge, 0), MCEdgeCorner(origin, edge, 1));
}

// The name that every cube around an edge gives it.
uint MCEdgeName(int3 origin, uint edge)
{
    return MCEdgeNameAt(MCEdgeCorner(origin, edge, 0), MCEdgeAxis(edge));
}

// Fills the vertex of every edge that the surface cuts (6.4.4, lines 15-20); MCTriangleEdge then names the edges of
// each triangle.
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
