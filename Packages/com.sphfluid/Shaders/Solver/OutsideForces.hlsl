#ifndef SPHFLUID_OUTSIDE_FORCES
#define SPHFLUID_OUTSIDE_FORCES

// What accelerates each particle by itself: a line for each force, and its file. A kernel that includes this file declares the keyword
// FLUID_ZONES.
#define FLUID_BODY_FORCE
#include "BodyForce.hlsl"
#include "ForceZones.hlsl"

float3 _Gravity;

float3 WithOutsideForces(float3 acceleration, float3 position, float3 velocity, float kick)
{
    acceleration += _Gravity;
    acceleration = any(_BodyForceRate != 0.0) ? acceleration + BodyForce(position) : acceleration;
#if defined(FLUID_ZONES)
    acceleration += ZoneAcceleration(position, velocity, kick);
#endif
    return acceleration;
}

#endif
