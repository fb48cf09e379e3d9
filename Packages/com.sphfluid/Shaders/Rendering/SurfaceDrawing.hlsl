// Vertex stage of the sparse surface: the index buffer names the vertex, no geometry shader.
#ifndef SPHFLUID_SURFACE_DRAWING_INCLUDED
#define SPHFLUID_SURFACE_DRAWING_INCLUDED

#include "../Surface/Sparse/SurfaceVertices.hlsl"
#include "../Surface/SurfaceFragment.hlsl"

SurfaceFragment FetchSurface(uint vertexId : SV_VertexID EYE_PARAMETER)
{
    EYE_OF_INSTANCE
    return ProjectSurfaceVertex(FetchSurfaceVertex(vertexId));
}

#endif
