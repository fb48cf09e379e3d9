#ifndef SPHFLUID_MESH_WALLS
#define SPHFLUID_MESH_WALLS

// What GatherWalls found for particles within R of a triangle. A kernel that includes this file declares
// "#pragma multi_compile_local _ FLUID_MESH_WALLS"; without, the domain's faces are all there is.
#include "FaceWalls.hlsl"
#include "NeighbourList.hlsl"
#include "PackedWall.hlsl"

#define NO_PLANE_DISTANCE 1e30 // m

// The walls that a particle sees, from a place.
struct NearWall
{
    float4 Planes[WALL_PLANES]; // unit normal towards the particle, distance of the place [m]; no plane: far away
    float3 Approach;   // speed of each plane along its normal, m/s
    float Friction;    // of the first triangle's wall, 0 free slip to 1 no slip; negative: that of the domain's faces
    float3 Velocity;   // of the first triangle's wall, m/s
    uint Flags;        // bits 0 to 2: the plane is a face's, not one beyond an edge; bits 4 and 5: the first triangle's plane, 3 for none
    float Share;       // of the kernel, behind the walls
    float3 Push[WALL_PLANES]; // its gradient where they were gathered, what each plane's wall has of it, 1/m
    float3 Turned;     // what the gradient has changed by since
};

#define DOMAIN_FRICTION 1023u

float2 UnpackHalves(uint packed)
{
    return float2(f16tof32(packed & 0xffffu), f16tof32(packed >> 16u));
}

#if defined(FLUID_MESH_WALLS)

StructuredBuffer<PackedWall> _NearWalls;
RWByteAddressBuffer _ContactsOut; // of FindContacts: groups x, y, z of ResolveContacts, and the number of particles

static const float OPPOSITE_FACES = -0.5; // the product of their normals: a wedge of up to 60 degrees parts what is beside it

NearWall WallOf(uint slot, float3 position)
{
    const PackedWall packed = _NearWalls[max(slot, 1u) - 1u];
    NearWall wall;
    [unroll]
    for (int k = 0; k < WALL_PLANES; k++)
    {
        const float3 normal = UnpackNormal(packed.Planes[k].Normal);
        wall.Planes[k] = float4(normal, dot(normal, position) - packed.Planes[k].Offset);
        wall.Approach[k] = f16tof32(packed.Planes[k].Approach);
    }
    const uint friction = (packed.VelocityZ >> 6u) & 1023u;
    wall.Velocity = float3(UnpackHalves(packed.VelocityXY), UnpackHalves(packed.VelocityZ).y);
    wall.Friction = friction == DOMAIN_FRICTION ? -1.0 : float(friction) / 1000.0;
    wall.Flags = packed.VelocityZ & 63u;
    const float3 gone = position - packed.Origin;
    const float2 xxyy = UnpackHalves(packed.Hessian.x);
    const float2 zzyz = UnpackHalves(packed.Hessian.y);
    const float2 zxxy = UnpackHalves(packed.Hessian.z);
    const float3 shear = float3(zzyz.y, zxxy.x, zxxy.y);
    wall.Push = packed.Push;
    wall.Turned = (float3(xxyy, zzyz.x) * gone + shear.zxy * gone.yzx + shear.yzx * gone.zxy) * (_InverseSupport * _InverseSupport);
    wall.Share = packed.Share + dot(packed.Push[0] + packed.Push[1] + packed.Push[2] + 0.5 * wall.Turned, gone);
    return wall;
}

WallDensity DensityOf(NearWall wall)
{
    WallDensity density;
    density.Value = wall.Share;
    density.Gradient = wall.Push[0] + wall.Push[1] + wall.Push[2] + wall.Turned;
    return density;
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
        const uint otherSlot = LISTS[_WallSlotBegin + other];
        const uint otherWall = max(otherSlot, 1u) - 1u;
        const uint faces = otherSlot != 0u ? _NearWalls[otherWall].VelocityZ & 7u : 0u;
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

// Of a particle; 0 of one that sees no triangle.
uint WallSlot(uint id)
{
#if defined(FLUID_MESH_WALLS)
    return LISTS[_WallSlotBegin + id];
#else
    return 0u;
#endif
}

// What walls add to the density, those of the domain or, near triangles, all.
WallDensity WallsOf(uint slot, float3 position)
{
    WallDensity walls = DomainWalls(position);
#if defined(FLUID_MESH_WALLS)
    [branch]
    if (slot != 0u)
    {
        walls = DensityOf(WallOf(slot, position));
    }
#endif
    return walls;
}

// Of a particle without a list, whether another that is near, d away, is its neighbour: by the other's list, unless that is being written.
bool IsUnlistedPair(bool isNear, uint id, float3 position, uint other, float3 otherPosition, float3 d)
{
#if !defined(SEARCHES)
    isNear = IsListedBy(isNear, other, id);
#endif
#if defined(FLUID_MESH_WALLS)
    const uint slot = isNear ? WallSlot(id) : 0u;
    [branch]
    if (slot != 0u)
    {
        isNear = !IsCut(WallOf(slot, position), other, otherPosition, d);
    }
#endif
    return isNear;
}

// For FindContacts of the same step: no particle, in no group of 1 x 1.
void EmptyContacts(uint id)
{
#if defined(FLUID_MESH_WALLS)
    if (id == 0u)
    {
        _ContactsOut.Store4(0u, uint4(0u, 1u, 1u, 0u));
    }
#endif
}

#endif
