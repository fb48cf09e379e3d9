#ifndef SPHFLUID_WALL_SHARES
#define SPHFLUID_WALL_SHARES

// What each wall has of the change of a particle's velocity in a step, for the rectangles on which the liquid's force is summed.
#if defined(FLUID_WALL_FORCES)

#include "../WallForces/WallPatches.hlsl"
#include "MeshWalls.hlsl"

// Of the faces of the domain. push: what the pressure does, -L' is multiplied by it, m^2/s; cut: what the shell and the face took, m/s.
void GiveFaces(float3 position, float push, float3 cut)
{
    const float3 below = position - _WallsLow;
    const float3 above = _WallsHigh - position;
    float3 open = float3(1.0, 1.0, 1.0);
    float3 low = float3(0.0, 0.0, 0.0);
    float3 high = float3(0.0, 0.0, 0.0);
    const bool near = any(min(below, above) < 0.5 / _InverseSupport);
    [unroll]
    for (int axis = 0; axis < 3; axis++)
    {
        const float2 lowProfile = MirrorProfile(below[axis]);
        const float2 highProfile = MirrorProfile(above[axis]);
        open[axis] = (1.0 - lowProfile.x) * (1.0 - highProfile.x);
        low[axis] = lowProfile.y * (1.0 - highProfile.x);
        high[axis] = highProfile.y * (1.0 - lowProfile.x);
    }
    const float3 both = near ? push * _InverseSupport * float3(open.y * open.z, open.x * open.z, open.x * open.y) : float3(0.0, 0.0, 0.0);
    low = low * both + max(cut, 0.0);
    high = high * both + max(-cut, 0.0);
    [loop]
    for (uint face = 0u; face < 6u; face++)
    {
        const uint along = face >> 1u;
        const float3 direction = float3(along == 0u ? 1.0 : 0.0, along == 1u ? 1.0 : 0.0, along == 2u ? 1.0 : 0.0);
        const bool isHigh = (face & 1u) != 0u;
        const float change = dot(direction, isHigh ? high : low);
        [branch]
        if (change != 0.0)
        {
            const float3 normal = isHigh ? -direction : direction;
            GiveToPatches(position - normal * dot(direction, isHigh ? above : below), normal, normal * change);
        }
    }
}

#if defined(FLUID_MESH_WALLS)

// Of the planes that a particle near triangles sees, those of the domain among them.
void GivePlanes(NearWall wall, float3 position, float3 changes[WALL_PLANES])
{
    [loop] // one copy of the loop over rectangles in the kernel, not three
    for (uint k = 0u; k < uint(WALL_PLANES); k++)
    {
        const float3 change = k == 0u ? changes[0] : k == 1u ? changes[1] : changes[2];
        [branch]
        if (any(change != 0.0))
        {
            const float4 plane = k == 0u ? wall.Planes[0] : k == 1u ? wall.Planes[1] : wall.Planes[2];
            GiveToPatches(position - plane.w * plane.xyz, plane.xyz, change);
        }
    }
}

#endif

#endif

#endif
