#ifndef SPHFLUID_SURFACE_VERTEX_INCLUDED
#define SPHFLUID_SURFACE_VERTEX_INCLUDED

struct SurfaceVertex
{
    float3 position; // simulation space [m]
    float3 normal;   // unit length, out of the liquid
};

#endif
