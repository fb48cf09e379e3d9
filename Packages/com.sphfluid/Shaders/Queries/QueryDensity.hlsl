#ifndef SPHFLUID_QUERY_DENSITY
#define SPHFLUID_QUERY_DENSITY

#include "QuerySpace.hlsl"
#include "../Solver/DomainFaces.hlsl"
#include "../Solver/Cells/Wendland.hlsl"

float _KernelFactor; // m 21 / (2 pi R^3)
float _RestDensity;

// Part of the kernel on the inner side of a plane at distance s R from its centre, 0 <= s: the integral of
// 21 (1/14 - z^2/2 + 5 z^4/2 - 4 z^5 + 5 z^6/2 - 4 z^7/7) from -1 to s. A half at the plane, 1 from s = 1 on.
float3 WendlandInside(float3 s)
{
    const float3 x = min(s, 1.0);
    const float3 q = x * x;
    return 0.5 + x * (1.5 + q * (-3.5 + q * (10.5 + x * (-14.0 + x * (7.5 - 1.5 * x)))));
}

float PartInside(float3 position)
{
    const float3 part = WendlandInside(max((position - _WallsLow) * _InverseSupport, 0.0))
        + WendlandInside(max((_WallsHigh - position) * _InverseSupport, 0.0)) - 1.0;
    return max(part.x * part.y * part.z, 0.125);
}

#endif
