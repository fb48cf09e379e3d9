#ifndef SPHFLUID_PACK_WALL
#define SPHFLUID_PACK_WALL

// Walls as they are stored: what MeshWalls.hlsl unpacks.
#include "MeshWalls.hlsl"

uint PackNormal(float3 n)
{
    n /= max(abs(n.x) + abs(n.y) + abs(n.z), 1e-9);
    const float2 fold = (1.0 - abs(n.yx)) * (n.xy >= 0.0 ? float2(1.0, 1.0) : float2(-1.0, -1.0));
    const int2 q = int2(round((n.z >= 0.0 ? n.xy : fold) * 32767.0));
    return (uint(q.x) & 0xffffu) | (uint(q.y) << 16u);
}

uint PackHalves(float low, float high)
{
    return f32tof16(low) | (f32tof16(high) << 16u);
}

// A plane at a distance from a place: the offset fits the normal as it is stored.
PackedPlane PackPlane(float3 position, float3 normal, float distance, float approach)
{
    PackedPlane packed;
    packed.Normal = PackNormal(normal);
    packed.Offset = dot(UnpackNormal(packed.Normal), position) - distance;
    packed.Approach = f32tof16(approach);
    return packed;
}

PackedPlane NoPlane()
{
    PackedPlane packed = (PackedPlane)0;
    packed.Offset = -NO_PLANE_DISTANCE;
    return packed;
}

// VelocityXY and VelocityZ.
uint2 PackMotion(float3 velocity, float friction, uint flags)
{
    const uint thousandths = friction < 0.0 ? DOMAIN_FRICTION : uint(round(friction * 1000.0));
    return uint2(PackHalves(velocity.x, velocity.y), (f32tof16(velocity.z) << 16u) | (thousandths << 6u) | flags);
}

#endif
