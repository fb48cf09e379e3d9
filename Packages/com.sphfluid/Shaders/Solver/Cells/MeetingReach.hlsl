#ifndef SPHFLUID_MEETING_REACH
#define SPHFLUID_MEETING_REACH

#include "Wendland.hlsl"

// Lists that serve several steps hold, besides the neighbours at the sort, pairs that come within R before the next: bodies of liquid that
// fall together would else overlap first. Inside the liquid neighbours part and come slowly, so only particles at a surface look
// ahead: a sorted position's w is 4 R times how far its particle goes until the next sort, in m^2, and below zero for one inside.
#define INSIDE_LIQUID -16.0 // R^2

// R^2. Who goes less than R/50 until the next sort looks nowhere ahead. A pair of them is late by 1/25 of R at most.
#define LEAST_MEETING_REACH 0.08

float _SupportSquared; // R^2, m^2
float _Ahead;          // s from the sort to the last step that uses its lists

bool LooksAhead(float w)
{
    return w > LEAST_MEETING_REACH * _SupportSquared;
}

// Squared distance below which two are within R or may come there: (1 + a + b)^2 < 1 + 4 (a + b), over R^2, as a and b are below 1.
// Worked example: two that go 0.1 and 0.3 may from 1.61 R.
float MeetingSquared(float w, float otherW)
{
    return max(_SupportSquared + w + otherW, _SupportSquared);
}

// Whether two particles come within R, going straight on.
bool Meets(float3 d, float3 relativeVelocity)
{
    const float time = clamp(-dot(d, relativeVelocity) / max(dot(relativeVelocity, relativeVelocity), 1e-20), 0.0, _Ahead);
    const float3 nearest = d + time * relativeVelocity;
    return dot(nearest, nearest) < _SupportSquared;
}

// The w of a sorted position. Faster than R in that time is looked for no farther than R: the cells end there.
float MeetingReach(bool atSurface, float3 velocity)
{
    const float reach = atSurface ? 4.0 * min(length(velocity) * _Ahead * _InverseSupport, 1.0) : INSIDE_LIQUID;
    return reach * _SupportSquared;
}

#endif
