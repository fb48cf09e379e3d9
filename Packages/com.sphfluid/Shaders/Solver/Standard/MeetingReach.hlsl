#ifndef SPHFLUID_MEETING_REACH
#define SPHFLUID_MEETING_REACH

#include "Wendland.hlsl"

// Lists that serve several steps hold, besides the neighbours at the sort, pairs that come within R before the next: bodies of liquid that
// fall together would else overlap first. Inside the liquid neighbours part and come slowly, so only particles at a surface look
// ahead: a sorted position's w is four times how far its particle goes until the next sort, over R, and below zero for one inside.
#define INSIDE_LIQUID -16.0

// Who goes less than this until the next sort looks nowhere ahead: four times 1/50 of R. A pair of them is late by 1/25 of R at most.
#define LEAST_MEETING_REACH 0.08

float _SupportSquared; // R^2, m^2
float _Ahead;          // s from the sort to the last step that uses its lists

bool LooksAhead(float w)
{
    return w > LEAST_MEETING_REACH;
}

// Whether two that are beyond R of each other may come within it: (1 + a + b)^2 < 1 + 4 (a + b) over R^2, as a and b are below 1.
// Worked example: two that go 0.1 and 0.3 may from 1.61 R.
bool MayMeet(float distanceSquared, float w, float otherW)
{
    return distanceSquared >= _SupportSquared && LooksAhead(otherW) && distanceSquared < _SupportSquared + (w + otherW) * _SupportSquared;
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
    return atSurface ? 4.0 * min(length(velocity) * _Ahead * _InverseSupport, 1.0) : INSIDE_LIQUID;
}

#endif
