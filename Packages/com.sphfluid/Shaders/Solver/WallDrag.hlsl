#ifndef SPHFLUID_WALL_DRAG
#define SPHFLUID_WALL_DRAG

// Walls that hold the liquid next to them. The stress of a particle at a distance d, mu (v - v_wall) / d, acts on the mass of
// its layer, rho dx an area: a = -beta nu (v - v_wall) / (d dx), in the wall's plane, where d < dx; the friction beta is 1 for
// no slip.
// A kernel that includes this file and has such walls defines FLUID_NO_SLIP.
#include "DomainFaces.hlsl"
#include "WallVelocities.hlsl"

#if defined(FLUID_NO_SLIP)
float _DragSpeed;    // beta nu / dx, m/s
float _DragDistance; // dx, m; far below zero where no wall holds the liquid
float _DragStep;     // s, the step of the velocities

// A value an axis where that axis has walls, zero where it is periodic.
float3 WhereWalls(float3 value)
{
#if defined(FLUID_PERIODIC)
    value = _PeriodLength > 0.0 ? float3(0.0, 0.0, 0.0) : value;
#endif
    return value;
}

// 1/s; a twentieth of dx is the nearest that counts.
float3 DragRate(float3 wallDistance)
{
    return wallDistance < _DragDistance ? _DragSpeed / max(wallDistance, 0.05 * _DragDistance) : float3(0.0, 0.0, 0.0);
}

// The six faces; each has friction along two axes. A step takes the whole difference of the velocities at most.
// Worked example: 0.5 dx from the lower y face, nu dt = 0.1 dx^2: rates (0, r, 0), r = 2 nu / dx^2; x and z lose 0.2 of v.
float3 DomainDrag(float3 low, float3 high, float3 velocity)
{
    const float3 rateLow = WhereWalls(DragRate(low));
    const float3 rateHigh = WhereWalls(DragRate(high));
    const float3 rates = rateLow + rateHigh;
    const float3 rate = rates.yzx + rates.zxy;
    return (WallDrive(rateLow, rateHigh) - rate * velocity) / max(rate * _DragStep, 1.0);
}

// A mesh at rest, by its nearest point: the unit vector and the distance from there, zero behind a closed one.
float3 MeshDrag(float3 away, float meshDistance, float3 velocity)
{
    const float rate = DragRate(meshDistance.xxx).x;
    return (away * dot(velocity, away) - velocity) * min(rate, 1.0 / _DragStep);
}
#endif

#endif
