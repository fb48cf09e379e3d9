#ifndef SPHFLUID_NEAR_WALL
#define SPHFLUID_NEAR_WALL

#define WALL_PLANES 3
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

// The same as it is stored, for any place of the particle until the walls are gathered again: a plane's distance is n.x - offset.
// Normals to 3e-5, the Hessian and what only holds velocities back to 3 digits. Mirrored by MeshWallBuffers.WallStride; 108 bytes.
struct PackedPlane
{
    uint Normal;       // octahedral, 16 bits a coordinate; axes are exact
    float Offset;      // m
    uint Approach;     // speed along the normal as a half float
};

struct PackedWall
{
    PackedPlane Planes[WALL_PLANES];
    uint VelocityXY;   // half floats
    uint VelocityZ;    // a half float, and below it friction in thousandths, 1023 for the domain's, and flags
    float3 Origin;     // where the walls were gathered, m
    float Share;       // there
    uint3 Hessian;     // R^2 times it: xx, yy, zz, yz, zx, xy as half floats
    float3 Push[WALL_PLANES]; // there, 1/m
};

#define DOMAIN_FRICTION 1023u
#define BRIEF_FLAG 8u // the share of the walls does not hold farther away
#define FACE_COSINE 0.98 // between the direction to a particle and the normal of the triangle that is nearest: less is beyond an edge

// How much of a plane one that comes before it leaves in sight: triangles of one plane hide each other, those square to each other do not.
float InSight(float4 before, float4 plane, float spacing)
{
    return 1.0 - saturate(dot(before.xyz, plane.xyz) * (plane.w / max(before.w, 1e-6 * spacing)));
}

// How much of a wall is there for a particle beyond its edge: less than of a half-space where it looks at the edge from the side, all of it at
// the edge itself, as if that were round by half a spacing.
float BeyondEdge(float distance, float facing, float spacing)
{
    const float seen = min(facing / FACE_COSINE, 1.0);
    const float squared = distance * distance;
    return 1.0 - (1.0 - seen * seen) * squared / (squared + 0.25 * spacing * spacing);
}

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
    const uint2 signs = asuint(p) & 0x80000000u;
    return normalize(float3(p - asfloat(asuint(max(-z, 0.0)) | signs), z));
}

uint PackHalves(float low, float high)
{
    return f32tof16(low) | (f32tof16(high) << 16u);
}

float2 UnpackHalves(uint packed)
{
    return float2(f16tof32(packed & 0xffffu), f16tof32(packed >> 16u));
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

// A bit for each plane that is a face's.
uint FacesOf(PackedWall packed)
{
    return packed.VelocityZ & 7u;
}

// inverseSupport: 1/R.
NearWall UnpackWall(PackedWall packed, float3 position, float inverseSupport)
{
    NearWall wall;
    [unroll]
    for (int k = 0; k < WALL_PLANES; k++)
    {
        const PackedPlane plane = packed.Planes[k];
        const float3 normal = UnpackNormal(plane.Normal);
        wall.Planes[k] = float4(normal, dot(normal, position) - plane.Offset);
        wall.Approach[k] = f16tof32(plane.Approach);
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
    const float3 turned = (float3(xxyy, zzyz.x) * gone + shear.zxy * gone.yzx + shear.yzx * gone.zxy) * (inverseSupport * inverseSupport);
    wall.Push = packed.Push;
    wall.Turned = turned;
    wall.Share = packed.Share + dot(packed.Push[0] + packed.Push[1] + packed.Push[2] + 0.5 * turned, gone);
    return wall;
}

#endif
