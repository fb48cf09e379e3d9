#ifndef SPHFLUID_MESH_WALLS
#define SPHFLUID_MESH_WALLS

// What GatherWalls found for particles within R of a triangle. A kernel that includes this file declares
// "#pragma multi_compile_local _ FLUID_MESH_WALLS".

#include "NearWall.hlsl"
#include "FaceWalls.hlsl"

#if defined(FLUID_MESH_WALLS)

StructuredBuffer<uint> _WallSlot;      // 0: none; else 1 + place in _NearWalls
StructuredBuffer<PackedWall> _NearWalls;

static const float OPPOSITE_FACES = -0.5; // the product of their normals: a wedge of up to 60 degrees parts what is beside it

NearWall WallOf(uint slot, float3 position)
{
    return UnpackWall(_NearWalls[max(slot, 1u) - 1u], position, _InverseSupport);
}

WallDensity DensityOf(NearWall wall)
{
    WallDensity density;
    density.Value = wall.Share;
    density.Gradient = wall.Push[0] + wall.Push[1] + wall.Push[2] + wall.Turned;
    return density;
}

// shares: what each plane's wall has of the gradient. Of its change each has what lies along its normal, the first the rest.
WallDensity DensityOf(NearWall wall, out float3 shares[WALL_PLANES])
{
    shares = wall.Push;
    float3 rest = wall.Turned;
    [unroll]
    for (int k = 0; k < WALL_PLANES; k++)
    {
        const float3 own = wall.Planes[k].w < NO_PLANE_DISTANCE * 0.5 ? dot(rest, wall.Planes[k].xyz) * wall.Planes[k].xyz : float3(0.0, 0.0, 0.0);
        shares[k] += own;
        rest -= own;
    }
    shares[0] += rest;
    return DensityOf(wall);
}

// What a particle's walls add; off is what it has without any.
WallDensity MeshDensity(uint slot, float3 position, WallDensity off)
{
    [branch]
    if (slot != 0u)
    {
        off = DensityOf(WallOf(slot, position));
    }
    return off;
}

// Whether a segment from a particle, -d, goes through a face that it sees and whose normal has less than this along n.
bool PassesFace(NearWall wall, float3 d, float3 n, float most)
{
    bool passes = false;
    [unroll]
    for (uint k = 0u; k < uint(WALL_PLANES); k++)
    {
        const bool seen = ((wall.Flags >> k) & 1u) != 0u;
        passes = passes || seen && dot(wall.Planes[k].xyz, d) > wall.Planes[k].w && dot(wall.Planes[k].xyz, n) < most;
    }
    return passes;
}

// Liquid on the other side of a thin sheet: both see a face between them, and these look against each other. Round a curved
// or a cornered body both see one as well, but that is one liquid: cut on and off as it moves, it never rests. Symmetric, so
// momentum is kept. The other's walls are read only where the own ones are passed, which elsewhere no neighbour does.
bool IsCut(NearWall wall, uint other, float3 otherPosition, float3 d)
{
    bool cut = false;
    [branch]
    if (PassesFace(wall, d, float3(0.0, 0.0, 0.0), 1.0))
    {
        const uint otherSlot = _WallSlot[other];
        const uint otherWall = max(otherSlot, 1u) - 1u;
        const uint faces = otherSlot != 0u ? FacesOf(_NearWalls[otherWall]) : 0u;
        for (uint k = 0u; faces >> k != 0u && !cut; k++) // few see more than one
        {
            const PackedPlane plane = _NearWalls[otherWall].Planes[k];
            const float3 n = UnpackNormal(plane.Normal);
            const bool passesBack = ((faces >> k) & 1u) != 0u && dot(n, -d) > dot(n, otherPosition) - plane.Offset;
            cut = passesBack && PassesFace(wall, d, n, OPPOSITE_FACES);
        }
    }
    return cut;
}

#endif

#endif
