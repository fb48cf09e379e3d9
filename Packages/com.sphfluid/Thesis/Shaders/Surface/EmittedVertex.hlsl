#ifndef SPHFLUID_EMITTED_VERTEX_INCLUDED
#define SPHFLUID_EMITTED_VERTEX_INCLUDED

// A triangle's corner. Mirrored by EmittedVertex in EmitSurfaceVerticesPass.cs: 32 bytes.
struct EmittedVertex
{
    float3 position; // simulation space [m]
    uint edge;       // name of the grid edge it lies on
    float3 normal;   // unit length, out of the liquid
    uint cube;       // number of the cube that emitted it
};

#endif
