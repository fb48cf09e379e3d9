#ifndef SPHFLUID_MESH_WALLS
#define SPHFLUID_MESH_WALLS

// What GatherWalls found for particles within R of a triangle. A kernel that includes this file declares
// "#pragma multi_compile_local _ FLUID_MESH_WALLS".

#include "NearWall.hlsl"

#if defined(FLUID_MESH_WALLS)

StructuredBuffer<uint> _WallSlot;      // 0: none; else 1 + place in _NearWalls
StructuredBuffer<PackedWall> _NearWalls;

NearWall WallOf(uint slot)
{
    return UnpackWall(_NearWalls[max(slot, 1u) - 1u]);
}

// Whether a segment from a particle, -d, goes through a face that it sees.
bool PassesFace(NearWall wall, float3 d)
{
    bool passes = false;
    [unroll]
    for (uint k = 0u; k < uint(WALL_PLANES); k++)
    {
        passes = passes || ((wall.Flags >> k) & 1u) != 0u && dot(wall.Planes[k].xyz, d) > wall.Planes[k].w;
    }
    return passes;
}

// Liquid on the other side of a thin sheet: both see a face between them. Symmetric, so momentum is kept. The other's walls
// are read only where the own ones are passed, which elsewhere no neighbour does.
bool IsCut(NearWall wall, uint other, float3 d)
{
    bool cut = false;
    [branch]
    if (PassesFace(wall, d))
    {
        const uint otherSlot = _WallSlot[other];
        cut = otherSlot != 0u && PassesFace(WallOf(otherSlot), -d);
    }
    return cut;
}

#endif

#endif
