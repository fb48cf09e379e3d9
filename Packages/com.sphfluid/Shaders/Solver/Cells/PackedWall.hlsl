#ifndef SPHFLUID_PACKED_WALL
#define SPHFLUID_PACKED_WALL

#define WALL_PLANES 3

// As stored, for any place until the walls are gathered again: a plane's distance is n.x - offset. Normals to 3e-5, the Hessian and what
// only holds velocities back to 3 digits. Mirrored by MeshWallBuffers.WallStride; 108 bytes.
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
    uint VelocityZ;    // a half float, and below it friction in thousandths, DOMAIN_FRICTION for the domain's, and flags
    float3 Origin;     // where the walls were gathered, m
    float Share;       // there
    uint3 Hessian;     // R^2 times it: xx, yy, zz, yz, zx, xy as half floats
    float3 Push[WALL_PLANES]; // there, 1/m
};

// Cigolle et al., A Survey of Efficient Representations for Independent Unit Vectors, 2014: oct32.
float3 UnpackNormal(uint packed)
{
    const float2 p = float2(int2(int(packed << 16u) >> 16, int(packed) >> 16)) / 32767.0;
    const float z = 1.0 - abs(p.x) - abs(p.y);
    const uint2 signs = asuint(p) & 0x80000000u;
    return normalize(float3(p - asfloat(asuint(max(-z, 0.0)) | signs), z));
}

#endif
