#ifndef SPHFLUID_WHITEWATER_WALLS
#define SPHFLUID_WHITEWATER_WALLS

// What the domain's walls hide: sums over neighbours are smaller beside them, though the liquid is as if it went on.
#include "../Solver/DomainFaces.hlsl"

float _SupportRadius; // R [m]

// Distance to the nearest wall along each axis [R], 1 at most.
float3 WallDistance(float3 position)
{
    return saturate(min(position - _WallsLow, _WallsHigh - position) / _SupportRadius);
}

// Part of a ball of radius R inside the walls: exact at one wall, a product of the axes near an edge.
float BallPartInside(float3 distance)
{
    const float3 part = 0.5 + distance * (0.75 - 0.25 * distance * distance);
    return part.x * part.y * part.z;
}

// Near a wall the middle of the neighbours lies away from it though the liquid goes on: along its normal it counts for less.
float3 WallFade(float3 distance)
{
    return distance * distance * (3.0 - 2.0 * distance);
}

#endif
