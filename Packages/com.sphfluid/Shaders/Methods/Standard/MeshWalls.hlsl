#ifndef SPHFLUID_MESH_WALLS
#define SPHFLUID_MESH_WALLS

// What GatherWalls found for particles within R of a triangle. A kernel that includes this file declares
// "#pragma multi_compile_local _ FLUID_MESH_WALLS".

// Mirrored by MeshWallBuffers.WallStride; 96 bytes.
struct NearWall
{
    float3 Gradient;   // of the walls' density over rho0, 1/m; the domain's faces included
    float Value;       // that density over rho0
    float4 Planes[3];  // unit normal towards the particle, distance [m]; no plane: distance 1e30
    float3 Approach;   // speed of each plane along its normal, m/s
    float Pad;
    float3 Velocity;   // of the first triangle's wall, m/s
    uint Flags;        // bits 0 to 2: the plane is a face's, not one beyond an edge; bits 4 and 5: the first triangle's plane, 3 for none
};

#if defined(FLUID_MESH_WALLS)

StructuredBuffer<uint> _WallSlot;      // 0: none; else 1 + place in _NearWalls
StructuredBuffer<NearWall> _NearWalls;

NearWall WallOf(uint slot)
{
    return _NearWalls[max(slot, 1u) - 1u];
}

// Whether a way from a particle, -d, goes through a face that it sees.
bool PassesFace(NearWall wall, float3 d)
{
    bool passes = false;
    [unroll]
    for (uint k = 0u; k < 3u; k++)
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
