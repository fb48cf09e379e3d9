#ifndef SPHFLUID_CLOSE_PAIRS
#define SPHFLUID_CLOSE_PAIRS

// What parts two particles that are too near to each other, whatever the pressure: where it is zero nothing else does.
//   a_i = sum_j w(r) (K + D max(0, -d.v_ij)) d,  d = x_i - x_j,  w = saturate(4 - 4 r^2/r0^2)
// K [1/s^2] parts two that rest. D [1/(m^2 s)] takes from the speed at which two approach, never from that at which they part: an
// inelastic collision, so no tension. Equal and opposite along d: momentum and angular momentum stay. Nothing acts beyond r0, which is
// less than the distances in liquid at rest, films and jets. After the repulsion of Clavet et al. 2005, which also acts at zero pressure,
// and the viscosity of Monaghan 1992, which acts on approach; both with less reach, and without a second sum.
// Worked example, dx = 1: r0 = 0.6; w = 1 up to r = 0.52, 0.64 at 0.55, 0 from 0.6 on.
float3 _ClosePairs; // 4/r0^2, K and D; these two over the factor of the pressure's sum

// What d is multiplied with.
//   distanceSquared  r^2
//   closing          d.v_ij, below zero where the two approach
float ClosePair(float distanceSquared, float closing)
{
    return saturate(4.0 - distanceSquared * _ClosePairs.x) * (_ClosePairs.y - _ClosePairs.z * min(closing, 0.0));
}

#endif
