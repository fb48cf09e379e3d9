#ifndef SPHFLUID_WHITEWATER_HASH
#define SPHFLUID_WHITEWATER_HASH

// PCG3D (Jarzynski and Olano 2020, "Hash functions for GPU rendering"): three numbers of three, the same on every device.
uint3 HashBits(uint3 v)
{
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

// From 0 to below 1, 24 bits each.
float3 HashUnit(uint3 v)
{
    return float3(HashBits(v) >> 8u) / 16777216.0;
}

#endif
