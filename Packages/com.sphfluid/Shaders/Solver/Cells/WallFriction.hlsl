#ifndef SPHFLUID_WALL_FRICTION
#define SPHFLUID_WALL_FRICTION

#include "../DomainFaces.hlsl"
#include "../WallVelocities.hlsl"
#include "Wendland.hlsl"

// No slip at the faces of the domain.
float _WallViscosity; // m^2/s
float _ShellDistance; // m: no particle is let nearer to a wall than this by its own speed

// Morris's sum over the liquid's mirror image behind a wall at rest, where velocities are opposite, (4 pi / d) times the integral
// of z W(z) from d to R = 42 u^5 (1 - 3u/2 + 4u^2/7) / (q R^2), q = d/R, u = 1 - q; for three walls at once.
// Worked example: kappa = 2.25, d = dx/2: 1.90 / dx^2; a lattice next to its mirror image has 1.94.
float3 MirrorDrag(float3 d)
{
    const float3 q = min(max(d, _ShellDistance) * _InverseSupport, 1.0); // 1/d: the shell keeps particles off
    const float3 u = 1.0 - q;
    const float3 u2 = u * u;
    return 42.0 * u2 * u2 * u * (1.0 - 1.5 * u + (4.0 / 7.0) * u2) / q * (_InverseSupport * _InverseSupport);
}

// The largest rate at which the faces take a velocity along an axis, 1/s.
float WallFrictionRate(float3 position)
{
    const float3 rates = MirrorDrag(position - _WallsLow) + MirrorDrag(_WallsHigh - position);
    const float3 across = rates.yzx + rates.zxy;
    return _WallViscosity * max(across.x, max(across.y, across.z));
}

// Whether a face with friction is within the support radius. By data, not by numbers alone.
bool IsHeld(float3 position)
{
    return _WallViscosity > 0.0 && any(min(position - _WallsLow, _WallsHigh - position) * _InverseSupport < 1.0);
}

// The six faces; each has friction along its two axes.
float3 WallFriction(float3 position, float3 velocity)
{
    const float3 rateLow = MirrorDrag(position - _WallsLow);
    const float3 rateHigh = MirrorDrag(_WallsHigh - position);
    const float3 rates = rateLow + rateHigh;
    return _WallViscosity * (WallDrive(rateLow, rateHigh) - (rates.yzx + rates.zxy) * velocity);
}

#endif
