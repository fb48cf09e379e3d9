// The thesis's drawing stages, 6.4.4: a vertex shader that passes its number on, one vertex a cube, and a geometry shader that turns the
// cube into triangles.
#ifndef SPHFLUID_SURFACE_GEOMETRY_INCLUDED
#define SPHFLUID_SURFACE_GEOMETRY_INCLUDED

#include "MarchingCubes.hlsl"
#include "../Rendering/FluidShading.hlsl"

struct CubePoint
{
    uint cube : TEXCOORD0;
};

struct SurfaceFragment
{
    float4 clipPosition : SV_Position;
    float3 world : TEXCOORD0;
    float3 normal : TEXCOORD1;
};

CubePoint PassThrough(uint vertexId : SV_VertexID)
{
    CubePoint output;
    output.cube = vertexId;
    return output;
}

SurfaceFragment ProjectSurfaceVertex(SurfaceVertex surface)
{
    SurfaceFragment fragment;
    fragment.world = FluidWorldPosition(surface.position);
    fragment.normal = FluidWorldDirection(surface.normal);
#if defined(FLUID_SHADOW_CASTER)
    fragment.clipPosition = FluidShadowClipPosition(fragment.world);
#else
    fragment.clipPosition = FluidClipPosition(fragment.world);
#endif
    return fragment;
}

#if defined(FLUID_CUBES)

#define MC_CUBE_VERTICES 24

// A corner of a cube's face: the face across an axis, lower or upper side, its corners in the order of a triangle strip. Cubes of the ring
// are as thin as it.
SurfaceVertex CubeFaceCorner(int3 origin, uint axis, uint upper, uint corner)
{
    int3 along = int3(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
    int3 first = upper != 0 ? along.zxy : along.yzx;
    int3 second = upper != 0 ? along.yzx : along.zxy;
    int3 v = origin + along * (int)upper + first * (int)(corner & 1) + second * (int)(corner >> 1);

    SurfaceVertex surface;
    surface.position = _MCGridMinimum.xyz + _MCCellSize.xyz * MCGridPosition(v);
    surface.normal = (float3)along * (upper != 0 ? 1.0 : -1.0);
    return surface;
}

// Fig. 12 of the thesis, middle: the cubes with at least one vertex inside. Cubes that lie wholly inside are hidden behind others.
[maxvertexcount(MC_CUBE_VERTICES)]
void GenerateIsosurface(point CubePoint input[1], inout TriangleStream<SurfaceFragment> triangles)
{
    int3 origin = MCCubeOrigin(input[0].cube);
    if (MCEdgeFlags(MCCubeIndex(origin)) != 0)
    {
        for (uint face = 0; face < 6; face++)
        {
            for (uint corner = 0; corner < 4; corner++)
                triangles.Append(ProjectSurfaceVertex(CubeFaceCorner(origin, face >> 1, face & 1, corner)));
            triangles.RestartStrip();
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
