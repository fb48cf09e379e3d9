#ifndef SPHFLUID_EDGE_SHADOW
#define SPHFLUID_EDGE_SHADOW

// The share of a particle's kernel that lies behind triangles, as sums over their edges. A direction in which the wall is met at the
// distance s adds Q(s) = (L(s) - s L'(s)) / 2 pi, L the profile of a plane (FaceWalls.hlsl), so that a whole plane adds L(d). For a
// triangle at d with the unit normal n towards the particle, an edge from a to b, t along it, tau from the foot of the particle on its
// line, which is at h:
//   s^2 = h^2 + tau^2,  w = n . (a x t),  dphi = w dtau / (w^2 + tau^2),  m = t x n
// L = 1/2pi sum int [L(d) - (d/s) L(s)] dphi = 1/2pi sum { L(d) int (1 - d/s) dphi, which is exact, + int (d/s) [L(d) - L(s)] dphi },
//            where both end as d goes to 0: nothing comes or goes at once when the particle crosses the plane beside the triangle
//   grad L = 1/2pi sum { n int [L'(d) - L'(s)] dphi + (t x h) int (L(s) - s L'(s)) / s^3 dtau }
//   Hess L = 1/2pi sum n (x) { n int [L''(d) - (d/s) L''(s)] dphi + m int L''(s)/s dtau },  its part that neighbours' edges do not cancel
// Beyond R/2 the profile is 0 and the rest is an angle. Nothing depends on how a surface is cut: what edges inside of a plane add cancels.
// All lengths are over R.
#include "FaceWalls.hlsl"

#define SHADOW_REACH 0.5

struct Profile
{
    float Value;
    float Slope; // over d/R
    float Bend;
};

struct Shadow
{
    float Value;
    float3 Gradient;
    float3 Diagonal; // xx, yy, zz of the Hessian
    float3 Shear;    // yz, zx, xy
};

Profile PlaneProfile(float d)
{
    const float3 z = min(2.0 * max(d, 0.0) + float3(0.0, 1.0, 2.0) * _MirrorSpacing, 1.0); // of the three layers
    const float3 z2 = z * z;
    const float3 u = 1.0 - z;
    const float3 u3 = u * u * u;
    const float3 value = 1.0 / 14.0 - z2 * (0.5 - z2 * (2.5 - 4.0 * z + 2.5 * z2 - (4.0 / 7.0) * z2 * z));
    const float3 slope = z * u3 * u * (4.0 * z + 1.0);
    const float3 bend = u3 * (u * (4.0 * z + 1.0) + z * (4.0 * u - 4.0 * (4.0 * z + 1.0)));
    Profile profile;
    profile.Value = dot(value, float3(1.0, 1.0, 1.0)) * 21.0 / _SupportRatio;
    profile.Slope = -dot(slope, float3(1.0, 1.0, 1.0)) * 42.0 / _SupportRatio;
    profile.Bend = -dot(bend, float3(1.0, 1.0, 1.0)) * 84.0 / _SupportRatio;
    return profile;
}

// Nearer than liquid rests the slope stays: where it is steeper a thin film on a curved wall is at the border of what the time step bears,
// and never rests.
float _SteepestWall; // dx

Profile ProfileAt(float d)
{
    const float least = _SteepestWall * _MirrorSpacing;
    Profile profile = PlaneProfile(max(d, least));
    const float nearer = min(d - least, 0.0);
    profile.Value += profile.Slope * nearer;
    profile.Bend = nearer < 0.0 ? 0.0 : profile.Bend;
    return profile;
}

#define NOWHERE 1e-30 // atan2(0, 0) is not a number on Direct3D: of a foot in a corner

// Over which an edge's part is seen from the foot of the particle in the plane.
float AngleOf(float across, float from, float to)
{
    return atan2(across * (to - from), across * across + from * to + NOWHERE);
}

// The same of d/s times it: the solid angle between edge, foot and particle is the one less the other.
float SolidAngleOf(float d, float across, float from, float to)
{
    const float first = sqrt(d * d + across * across + from * from);
    const float last = sqrt(d * d + across * across + to * to);
    return atan2(across * d * (to * first - from * last), across * across * first * last + d * d * from * to + NOWHERE);
}

float ArSinh(float x)
{
    const float a = abs(x);
    const float y = log(a + sqrt(a * a + 1.0));
    return x < 0.0 ? -y : y;
}

// Gauss and Legendre's points and weights on -1 to 1, of one to four points one after the other.
static const float2 GAUSS[10] =
{
    float2(0.0, 2.0),
    float2(-0.57735027, 1.0), float2(0.57735027, 1.0),
    float2(-0.77459667, 0.55555556), float2(0.0, 0.88888889), float2(0.77459667, 0.55555556),
    float2(-0.86113631, 0.34785485), float2(-0.33998104, 0.65214515), float2(0.33998104, 0.65214515), float2(0.86113631, 0.34785485)
};

// Corners relative to the particle, counter-clockwise about n as it sees them. inPlane: bits for the edges ab, bc, ca whose other triangle
// lies in the same plane.
Shadow ShadowOf(float3 a, float3 b, float3 c, float3 n, float d, uint inPlane)
{
    const Profile plane = ProfileAt(d);
    const float least = 1e-4 * _MirrorSpacing;
    float value = 0.0;
    float slope = 0.0;
    float bend = 0.0;
    float3 rims = float3(0.0, 0.0, 0.0);
    float3 turns = float3(0.0, 0.0, 0.0);
    [loop]
    for (uint k = 0u; k < 3u; k++)
    {
        const float3 from = k == 0u ? a : k == 1u ? b : c;
        const float3 edge = (k == 0u ? b : k == 1u ? c : a) - from;
        const float size = length(edge);
        const float3 t = edge / max(size, 1e-9);
        const float begin = dot(from, t);
        const float end = begin + size;
        const float3 foot = from - begin * t;
        const float across = dot(n, cross(from, t));
        const float h2 = d * d + across * across;
        const float half = sqrt(max(SHADOW_REACH * SHADOW_REACH - h2, 0.0));
        const float low = max(begin, -half);
        const float high = min(end, half);
        const bool inReach = low < high;
        const float angleOfAll = AngleOf(across, begin, end);
        const float outer = angleOfAll - (inReach ? AngleOf(across, low, high) : 0.0);
        value += plane.Value * (angleOfAll - (inReach ? SolidAngleOf(d, across, low, high) : 0.0));
        slope += plane.Slope * outer;
        bend += plane.Bend * outer;
        const uint points = size < 0.35 * _MirrorSpacing ? 1u : size < 0.6 * _MirrorSpacing ? 2u : size < 1.01 * _MirrorSpacing ? 3u : 4u;
        const float h = max(sqrt(h2), least);
        const float first = ArSinh(low / h);
        const float last = ArSinh(high / h);
        float rim = 0.0;
        float turn = 0.0;
        [loop]
        for (uint q = 0u; q < (inReach && ((inPlane >> k) & 1u) == 0u ? points : 0u); q++)
        {
            const float2 rule = GAUSS[points * (points - 1u) / 2u + q];
            const float u = 0.5 * (first + last) + 0.5 * (last - first) * rule.x;
            const float tau = 0.5 * h * (exp(u) - exp(-u)); // close points where the edge is close
            const float s2 = max(h2 + tau * tau, least * least);
            const float s = sqrt(s2);
            const float weight = 0.5 * (last - first) * rule.y * s;
            const float angle = weight * across / max(across * across + tau * tau, 1e-2 * least * least);
            const Profile there = ProfileAt(s);
            value += angle * d / s * (plane.Value - there.Value);
            slope += angle * (plane.Slope - there.Slope);
            bend += angle * (plane.Bend - d / s * there.Bend);
            rim += weight * (there.Value - s * there.Slope) / (s2 * s);
            turn += weight * there.Bend / s;
        }
        rims += rim * cross(t, foot);
        turns += turn * cross(t, n);
    }
    const float turnsInverse = 0.15915494; // 1 / 2 pi
    const float3 bends = bend * n + turns;
    Shadow shadow;
    shadow.Value = turnsInverse * value;
    shadow.Gradient = turnsInverse * (slope * n + rims);
    shadow.Diagonal = turnsInverse * n * bends;
    shadow.Shear = 0.5 * turnsInverse * (n.yzx * bends.zxy + n.zxy * bends.yzx);
    return shadow;
}

#endif
