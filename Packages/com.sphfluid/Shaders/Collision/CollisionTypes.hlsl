#ifndef SPHFLUID_COLLISION_TYPES
#define SPHFLUID_COLLISION_TYPES

// Simulation space; cross(B - A, C - A) points to the front, outwards where the mesh is closed. 48 bytes.
struct CollisionTriangle
{
    float3 A;
    float Pad0;
    float3 B;
    float Pad1;
    float3 C;
    float Pad2;
};

// One mesh: its triangles and their box. 32 bytes.
struct CollisionCollider
{
    float3 BoundsMin;
    uint FirstTriangle;
    float3 BoundsMax;
    uint TriangleCount; // bit 31 (COLLIDER_CLOSED): the mesh encloses a volume
};

#define COLLIDER_CLOSED 0x80000000u
#define COLLIDER_COUNT_MASK 0x3fffffffu

#endif
