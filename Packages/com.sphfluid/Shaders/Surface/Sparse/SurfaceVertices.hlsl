// The sparse surface as a vertex shader reads it: drawn indexed, so that SV_VertexID is the number of the vertex.
#ifndef SPHFLUID_SURFACE_VERTICES_INCLUDED
#define SPHFLUID_SURFACE_VERTICES_INCLUDED

#include "PackedSurfaceVertex.hlsl"

StructuredBuffer<PackedSurfaceVertex> _SurfaceVertices;

SurfaceVertex FetchSurfaceVertex(uint id)
{
    PackedSurfaceVertex packed = _SurfaceVertices[id];
    SurfaceVertex surface;
    surface.position = packed.position;
    surface.normal = UnpackSurfaceNormal(packed.normal);
    return surface;
}

#endif
