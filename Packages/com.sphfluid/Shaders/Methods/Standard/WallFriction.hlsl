#ifndef SPHFLUID_WALL_FRICTION
#define SPHFLUID_WALL_FRICTION

#include "../../Neighbours/PeriodicAxes.hlsl"

// No slip at the faces of the domain.
#if defined(FLUID_NO_SLIP)

float _WallViscosity; // beta nu, beta = 1.5: m^2/s
float3 _WallLowX;     // m/s, velocities of the domain's faces, each within its plane
float3 _WallLowY;
float3 _WallLowZ;
float3 _WallHighX;
float3 _WallHighY;
float3 _WallHighZ;

// Morris's sum over a half-space at rest, 14 u^5 (3 - 2u) / R^2, u = 1 - d/R, for three walls at once.
float3 HalfSpaceDrag(float3 d)
{
    const float3 u = max(1.0 - max(d, 0.0) * _InverseSupport, 0.0);
    const float3 u2 = u * u;
    return 14.0 * u2 * u2 * u * (3.0 - 2.0 * u) * (_InverseSupport * _InverseSupport);
}

// The six faces; each rubs along its two axes.
float3 WallFriction(float3 position, float3 velocity)
{
    const float3 rateLow = WhereWalls(HalfSpaceDrag(_DomainHalfSize + position));
    const float3 rateHigh = WhereWalls(HalfSpaceDrag(_DomainHalfSize - position));
    const float3 rates = rateLow + rateHigh;
    const float3 drive = rateLow.x * _WallLowX + rateHigh.x * _WallHighX + rateLow.y * _WallLowY + rateHigh.y * _WallHighY
        + rateLow.z * _WallLowZ + rateHigh.z * _WallHighZ;
    return _WallViscosity * (drive - (rates.yzx + rates.zxy) * velocity);
}

#endif

#endif
