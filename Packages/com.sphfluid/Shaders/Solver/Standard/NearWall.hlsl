#ifndef SPHFLUID_NEAR_WALL
#define SPHFLUID_NEAR_WALL

#include "Wendland.hlsl"

#define WALL_PLANES 3
#define NO_PLANE_DISTANCE 6e4 // over R: as far as a half float goes

// The walls that a particle sees.
struct NearWall
{
    float3 Gradient;   // of the walls' density over rho0, 1/m; the domain's faces included
    float Value;       // that density over rho0
    float4 Planes[WALL_PLANES]; // unit normal towards the particle, distance [m]; no plane: far away
    float3 Approach;   // speed of each plane along its normal, m/s
    float Friction;    // of the first triangle's wall, 0 free slip to 1 no slip; negative: that of the domain's faces
    float3 Velocity;   // of the first triangle's wall, m/s
    uint Flags;        // bits 0 to 2: the plane is a face's, not one beyond an edge; bits 4 and 5: the first triangle's plane, 3 for none
};

// The same as it is stored: density and force in full, what only holds velocities back to 3 digits, normals to 3e-5.
// Mirrored by MeshWallBuffers.WallStride; 48 bytes.
struct PackedWall
{
    float3 Gradient;
    float Value;
    uint3 Normals;   // octahedral, 16 bits a coordinate; axes are exact
    uint3 Distances; // half floats: distance over R, speed along the normal
    uint2 Motion;    // half floats: velocity x, y; z and below it friction in thousandths, 1023 for the domain's, and flags
};

#define DOMAIN_FRICTION 1023u

// Cigolle et al., A Survey of Efficient Representations for Independent Unit Vectors, 2014: oct32.
uint PackNormal(float3 n)
{
    n /= max(abs(n.x) + abs(n.y) + abs(n.z), 1e-9);
    const float2 fold = (1.0 - abs(n.yx)) * (n.xy >= 0.0 ? float2(1.0, 1.0) : float2(-1.0, -1.0));
    const int2 q = int2(round((n.z >= 0.0 ? n.xy : fold) * 32767.0));
    return (uint(q.x) & 0xffffu) | (uint(q.y) << 16u);
}

float3 UnpackNormal(uint packed)
{
    const float2 p = float2(int2(int(packed << 16u) >> 16, int(packed) >> 16)) / 32767.0;
    const float z = 1.0 - abs(p.x) - abs(p.y);
    const float2 fold = (1.0 - abs(p.yx)) * (p >= 0.0 ? float2(1.0, 1.0) : float2(-1.0, -1.0));
    return normalize(float3(z >= 0.0 ? p : fold, z));
}

uint PackHalves(float low, float high)
{
    return f32tof16(low) | (f32tof16(high) << 16u);
}

float2 UnpackHalves(uint packed)
{
    return float2(f16tof32(packed & 0xffffu), f16tof32(packed >> 16u));
}

PackedWall PackWall(NearWall wall)
{
    PackedWall packed;
    packed.Gradient = wall.Gradient;
    packed.Value = wall.Value;
    [unroll]
    for (int k = 0; k < WALL_PLANES; k++)
    {
        packed.Normals[k] = PackNormal(wall.Planes[k].xyz);
        packed.Distances[k] = PackHalves(min(wall.Planes[k].w * _InverseSupport, NO_PLANE_DISTANCE), wall.Approach[k]);
    }
    const uint friction = wall.Friction < 0.0 ? DOMAIN_FRICTION : uint(round(wall.Friction * 1000.0));
    packed.Motion = uint2(PackHalves(wall.Velocity.x, wall.Velocity.y), (f32tof16(wall.Velocity.z) << 16u) | (friction << 6u) | wall.Flags);
    return packed;
}

NearWall UnpackWall(PackedWall packed)
{
    NearWall wall;
    wall.Gradient = packed.Gradient;
    wall.Value = packed.Value;
    [unroll]
    for (int k = 0; k < WALL_PLANES; k++)
    {
        const float2 halves = UnpackHalves(packed.Distances[k]);
        wall.Planes[k] = float4(UnpackNormal(packed.Normals[k]), halves.x / _InverseSupport);
        wall.Approach[k] = halves.y;
    }
    const uint friction = (packed.Motion.y >> 6u) & 1023u;
    wall.Velocity = float3(UnpackHalves(packed.Motion.x), UnpackHalves(packed.Motion.y).y);
    wall.Friction = friction == DOMAIN_FRICTION ? -1.0 : float(friction) / 1000.0;
    wall.Flags = packed.Motion.y & 63u;
    return wall;
}

#endif
