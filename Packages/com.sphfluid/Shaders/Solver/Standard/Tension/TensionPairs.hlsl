#ifndef SPHFLUID_TENSION_PAIRS
#define SPHFLUID_TENSION_PAIRS

// Walls for the two passes of surface tension, and what they share. Lengths of 0 leave every number as it is, so no variant is needed.
#define FLUID_PERIODIC

#include "../../Cells/CellTypes.hlsl"
#include "../../Cells/CellRows.hlsl"
#include "../../Cells/Wendland.hlsl"
#include "../../Cells/FaceWalls.hlsl"
#include "../../Cells/MeshWalls.hlsl"

// The gradient of what walls add to the density, 1/m.
float3 WallGradient(uint id, float3 position)
{
    float3 gradient = DomainWalls(position).Gradient;
#if defined(FLUID_MESH_WALLS)
    const uint slot = _WallSlot[id];
    [branch]
    if (slot != 0u)
    {
        gradient = DensityOf(WallOf(slot, position)).Gradient;
    }
#endif
    return gradient;
}

#endif
