#ifndef SPHFLUID_PACKED_SURFACE_VERTEX_INCLUDED
#define SPHFLUID_PACKED_SURFACE_VERTEX_INCLUDED

#include "../SurfaceVertex.hlsl"

// A vertex of the sparse surface; mirrored by PackedSurfaceVertex in SurfaceTriangles.cs, 16 bytes.
struct PackedSurfaceVertex
{
    float3 position; // simulation space [m]
    uint normal;     // octahedral, 16 bits x (low) and 16 bits y
};

// The unit sphere on an octahedron, the octahedron unfolded into a square of -32767 to 32767 (Meyer et al. 2010, "On
// floating-point normal vectors"). Off by 0.004 degrees at most. Worked example: (0, 0, 1) lies at (0, 0), (0, 0, -1)
// in the square's corners.
uint PackSurfaceNormal(float3 normal)
{
    float2 p = normal.xy / (abs(normal.x) + abs(normal.y) + abs(normal.z));
    float2 folded = (1.0 - abs(p.yx)) * (p >= 0.0 ? (float2)1.0 : (float2)-1.0);
    int2 units = (int2)round((normal.z < 0.0 ? folded : p) * 32767.0);
    return ((uint)units.x & 0xffffu) | ((uint)units.y << 16);
}

float3 UnpackSurfaceNormal(uint packed)
{
    int2 units = int2((int)(packed << 16) >> 16, (int)packed >> 16);
    float3 normal = float3((float2)units / 32767.0, 0.0);
    normal.z = 1.0 - abs(normal.x) - abs(normal.y);
    float fold = max(-normal.z, 0.0);
    normal.xy -= normal.xy >= 0.0 ? (float2)fold : (float2)-fold;
    return normalize(normal);
}

PackedSurfaceVertex PackSurfaceVertex(SurfaceVertex surface)
{
    PackedSurfaceVertex packed;
    packed.position = surface.position;
    packed.normal = PackSurfaceNormal(surface.normal);
    return packed;
}

#endif
