// The field of marching cubes at every vertex of the grid.
#ifndef SPHFLUID_DENSE_FIELD_INCLUDED
#define SPHFLUID_DENSE_FIELD_INCLUDED

#include "SurfaceGrid.hlsl"

StructuredBuffer<float> _MCGrid; // a density factor a grid vertex, x fastest: density / rest density

bool MCHasValue(int3 v)
{
    return MCInGrid(v);
}

// Outside the grid there is no liquid.
float MCFieldValue(int3 v)
{
    float value = 0.0;
    if (MCInGrid(v))
        value = _MCGrid[MCVertexIndex((uint3)v)];
    return value;
}

#endif
