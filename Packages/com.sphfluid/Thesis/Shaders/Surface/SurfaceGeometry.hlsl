// The thesis's drawing stages, 6.4.4: a vertex shader that passes its number on, one vertex a cube, and a geometry
// shader that turns the cube into triangles.
#ifndef SPHFLUID_SURFACE_GEOMETRY_INCLUDED
#define SPHFLUID_SURFACE_GEOMETRY_INCLUDED

#include "DenseField.hlsl"
#include "Packages/com.sphfluid/Shaders/Surface/MarchingCubes.hlsl"
#include "Packages/com.sphfluid/Shaders/Surface/SurfaceFragment.hlsl"

struct CubePoint
{
    uint cube : TEXCOORD0;
};

CubePoint PassThrough(uint vertexId : SV_VertexID)
{
    CubePoint output;
    output.cube = vertexId;
    return output;
}

#if defined(FLUID_CUBES)

// A corner of a cube as the end of a line. It is lit like the liquid's surface; where the density is even, deep inside,
// it is turned from the light.
SurfaceVertex CubeCorner(int3 v)
{
    float3 outwards = MCInGrid(v) ? -MCGradient(clamp(v, 0, MCCells())) : (float3)0.0;
    float squared = dot(outwards, outwards);

    SurfaceVertex surface;
    surface.position = MCPosition(MCGridPosition(v));
    surface.normal = squared > 0.0 ? outwards * rsqrt(squared) : float3(0.0, -1.0, 0.0);
    return surface;
}

// Fig. 12 of the thesis, middle: the edges of the cubes with at least one vertex inside. Cubes of the ring are as thin
// as it.
[maxvertexcount(2 * MC_EDGES)]
void GenerateIsosurface(point CubePoint input[1], inout LineStream<SurfaceFragment> lines)
{
    int3 origin = MCCubeOrigin(input[0].cube);
    if (MCCubeIndex(origin) != MC_ALL_OUTSIDE)
    {
        for (uint edge = 0; edge < MC_EDGES; edge++)
        {
            lines.Append(ProjectSurfaceVertex(CubeCorner(MCEdgeCorner(origin, edge, 0))));
            lines.Append(ProjectSurfaceVertex(CubeCorner(MCEdgeCorner(origin, edge, 1))));
            lines.RestartStrip();
        }
    }
}

#else

[maxvertexcount(MC_MAX_VERTICES)]
void GenerateIsosurface(point CubePoint input[1], inout TriangleStream<SurfaceFragment> triangles)
{
    int3 origin = MCCubeOrigin(input[0].cube);
    uint cubeIndex = MCCubeIndex(origin);
    uint count = MCVertexCount(cubeIndex);
    if (count > 0)
    {
        SurfaceVertex vertexList[MC_EDGES];
        Polygonise(origin, cubeIndex, vertexList);
        for (uint slot = 0; slot < count; slot += 3)
        {
            for (uint corner = 0; corner < 3; corner++)
                triangles.Append(ProjectSurfaceVertex(vertexList[(uint)MCTriangleEdge(cubeIndex, slot + corner)]));
            triangles.RestartStrip();
        }
    }
}

#endif

#endif
