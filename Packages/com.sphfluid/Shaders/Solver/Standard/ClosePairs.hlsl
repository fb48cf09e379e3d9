#ifndef SPHFLUID_CLOSE_PAIRS
#define SPHFLUID_CLOSE_PAIRS

// What parts two particles that are too near to each other, whatever the pressure: where it is zero nothing else does.
//   a_i = sum_j w(r) / (r^2 + e^2) (K + D max(0, -d.v_ij)) d,  d = x_i - x_j,  w = saturate(2 - 2 r^2/r0^2)
// K [m^2/s^2] parts two that rest: from 0.3 dx with 1.5 sqrt(K). D [1/s] takes from the speed at which
// the two approach, never from that at which they part: an inelastic collision, so no tension. Equal and opposite along d: momentum and
// angular momentum stay. Nothing beyond r0, which is less than the distances of liquid at rest. Like the short-range terms of
// Clavet et al. 2005 (repulsion) and Monaghan 1992 (viscosity of approach), with less reach and without a second sum.
// Worked example, dx = 1: r0 = 0.65, e = 0.1: w = 1 up to r = 0.46, 0.82 at 0.5, 0.30 at 0.6, 0 from 0.65 on.
float4 _ClosePairs; // 2/r0^2, e^2, K and D; these two over the factor of the pressure's sum

float3 ClosePair(float3 d, float distanceSquared, float3 relativeVelocity)
{
    const float weight = saturate(2.0 - distanceSquared * _ClosePairs.x) / (distanceSquared + _ClosePairs.y);
    return weight * (_ClosePairs.z + _ClosePairs.w * max(-dot(d, relativeVelocity), 0.0)) * d;
}

#endif
