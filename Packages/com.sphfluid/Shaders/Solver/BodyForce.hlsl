#ifndef SPHFLUID_BODY_FORCE
#define SPHFLUID_BODY_FORCE

// A force per mass towards a point, a = -w^2 (x - centre), an axis each.
// A kernel that includes this file and has such a force defines FLUID_BODY_FORCE.
#if defined(FLUID_BODY_FORCE)
float3 _BodyForceCentre; // m
float3 _BodyForceRate;   // w^2, 1/s^2; 0: no force

float3 BodyForce(float3 position)
{
    return _BodyForceRate * (_BodyForceCentre - position);
}
#endif

#endif
