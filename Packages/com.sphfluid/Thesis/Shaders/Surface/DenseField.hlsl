// The field of marching cubes at every vertex of the grid.
#ifndef SPHFLUID_DENSE_FIELD_INCLUDED
#define SPHFLUID_DENSE_FIELD_INCLUDED

#include "Packages/com.sphfluid/Shaders/Surface/SurfaceGrid.hlsl"

StructuredBuffer<float> _MCGrid; // a density factor a grid vertex, x fastest: density / rest density

int3 MCKnownAbove(int3 v)
{
    return min(v + 1, MCCells());
}

int3 MCKnownBelow(int3 v)
{
    return max(v - 1, 0);
}

float MCKnownValue(int3 v)
{
    return _MCGrid[MCVertexIndex((uint3)v)];
}

// Outside the grid there is no liquid.
float MCFieldValue(int3 v)
{
    float value = 0.0;
    if (MCInGrid(v))
        value = MCKnownValue(v);
    return value;
}

#endif
