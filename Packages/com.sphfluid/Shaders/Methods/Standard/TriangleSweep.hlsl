#ifndef SPHFLUID_TRIANGLE_SWEEP
#define SPHFLUID_TRIANGLE_SWEEP

// Motion of a point against one triangle, by separating planes. For any unit n, min_i (x - v_i).n over the corners is a lower
// bound of the distance; where it is positive at both ends of a straight way, the way misses the triangle, its edges and its
// corners. A badly rounded n proves less, never wrongly.
#include "../../Collision/Bodies.hlsl"

float _ContactDistance;  // r_c: where particles come to rest, 0.1 dx
float _SweepDistance;    // rho = 0.9 r_c: no motion is let nearer
float _ContactFloor;     // r_f: gaps do not go below
float _ContactTolerance; // of r_c at rest

#define SWEEP_ADVANCES 7

struct Gap
{
    float Value;   // certified lower bound of the distance
    float3 Normal; // that proves it
};

struct Sweep
{
    bool Hit;      // the whole way is not proved free
    bool Soft;     // free, but it ends nearer than the contact distance
    float Time;    // proved free up to here, 0 to 1
    float3 Normal;
    float EndGap;
    float StartGap;
};

float Support(float3 x, BodyTriangle tri, float3 n)
{
    return min(dot(x - tri.A, n), min(dot(x - tri.B, n), dot(x - tri.C, n)));
}

float3 Across(float3 r, float3 edge)
{
    const float squared = dot(edge, edge);
    return squared > 0.0 ? r - edge * (dot(r, edge) / squared) : r;
}

// From the nearest point of an edge to x, square to the edge.
float3 FromEdge(float3 x, float3 a, float3 b)
{
    const float3 edge = b - a;
    const float squared = dot(edge, edge);
    const float u = squared > 0.0 ? saturate(dot(x - a, edge) / squared) : 0.0;
    const float3 r = x - a - edge * u;
    return u > 0.0 && u < 1.0 ? Across(r, edge) : r;
}

// From the nearest point of the triangle to x, by regions (Ericson 2005). In edge regions it is made square to the edge, in the
// face region it is along the normal: the direction then errs by rounding only, however long the triangle.
float3 FromTriangle(float3 x, BodyTriangle tri)
{
    const float3 ab = tri.B - tri.A;
    const float3 ac = tri.C - tri.A;
    const float3 ap = x - tri.A;
    const float3 bp = x - tri.B;
    const float3 cp = x - tri.C;
    const float d1 = dot(ab, ap);
    const float d2 = dot(ac, ap);
    const float d3 = dot(ab, bp);
    const float d4 = dot(ac, bp);
    const float d5 = dot(ab, cp);
    const float d6 = dot(ac, cp);
    const float vc = d1 * d4 - d3 * d2;
    const float vb = d5 * d2 - d1 * d6;
    const float va = d3 * d6 - d5 * d4;
    float3 r;
    if (d1 <= 0.0 && d2 <= 0.0)
    {
        r = ap;
    }
    else if (d3 >= 0.0 && d4 <= d3)
    {
        r = bp;
    }
    else if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
    {
        r = FromEdge(x, tri.A, tri.B);
    }
    else if (d6 >= 0.0 && d5 <= d6)
    {
        r = cp;
    }
    else if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
    {
        r = FromEdge(x, tri.A, tri.C);
    }
    else if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
    {
        r = FromEdge(x, tri.B, tri.C);
    }
    else
    {
        const float3 n = cross(ab, ac);
        const float squared = dot(n, n);
        r = squared > 0.0 ? n * (dot(ap, n) / squared) : ap;
    }
    return r;
}

void Better(float3 x, BodyTriangle tri, float3 direction, inout Gap gap)
{
    const float squared = dot(direction, direction);
    if (squared > 1e-20)
    {
        const float3 n = direction * rsqrt(squared);
        const float value = Support(x, tri, n);
        if (value > gap.Value)
        {
            gap.Value = value;
            gap.Normal = n;
        }
    }
}

Gap GapOf(float3 x, BodyTriangle tri)
{
    Gap gap;
    gap.Value = -1e30;
    gap.Normal = float3(0.0, 0.0, 1.0);
    const float3 r = FromTriangle(x, tri);
    const float reach = length(r);
    Better(x, tri, r, gap);
    if (gap.Value < 0.98 * reach || reach < 1e-10)
    {
        // Needles, and points on the triangle: the best of the face's normal and the edges.
        const float3 face = cross(tri.B - tri.A, tri.C - tri.A);
        Better(x, tri, dot(x - tri.A, face) < 0.0 ? -face : face, gap);
        Better(x, tri, FromEdge(x, tri.A, tri.B), gap);
        Better(x, tri, FromEdge(x, tri.B, tri.C), gap);
        Better(x, tri, FromEdge(x, tri.C, tri.A), gap);
        gap.Value = gap.Value < -1e29 ? 0.0 : gap.Value;
    }
    return gap;
}

// Newton's steps on the convex gap; they never overshoot. cap: relaxes the distance where the particle is nearer already.
Sweep SweepTriangle(float3 from, float3 to, BodyTriangle tri, float cap)
{
    Sweep sweep;
    const float3 way = to - from;
    Gap gap = GapOf(from, tri);
    sweep.StartGap = gap.Value;
    sweep.Hit = true;
    sweep.Soft = false;
    sweep.Time = 0.0;
    const float distance = min(_SweepDistance, max(_ContactFloor, 0.99 * min(gap.Value, cap)));
    float endGap = 0.0;
    [loop]
    for (int i = 0; i < SWEEP_ADVANCES && sweep.Hit; i++)
    {
        const float approach = -dot(way, gap.Normal);
        endGap = Support(to, tri, gap.Normal);
        if (endGap >= distance || approach <= 0.0)
        {
            sweep.Hit = false;
        }
        else if (gap.Value - distance <= 0.02 * distance)
        {
            break;
        }
        else
        {
            sweep.Time = min(1.0, sweep.Time + (gap.Value - distance) / approach);
            gap = GapOf(from + way * sweep.Time, tri);
        }
    }
    sweep.Normal = gap.Normal;
    sweep.EndGap = Support(to, tri, gap.Normal);
    if (!sweep.Hit && sweep.EndGap < _ContactDistance - _ContactTolerance)
    {
        const Gap end = GapOf(to, tri);
        if (end.Value < _ContactDistance - _ContactTolerance && dot(way, end.Normal) <= 0.0)
        {
            sweep.Soft = true;
            sweep.Normal = end.Normal;
            sweep.EndGap = end.Value;
        }
    }
    return sweep;
}

// Whether a way of a body's frame cannot come near the triangle.
bool PassesBy(float3 from, float3 to, BodyTriangle tri)
{
    const float3 n = NormalOf(tri);
    const float s0 = dot(from - tri.A, n);
    const float s1 = dot(to - tri.A, n);
    const float3 low = min(tri.A, min(tri.B, tri.C)) - _ContactDistance;
    const float3 high = max(tri.A, max(tri.B, tri.C)) + _ContactDistance;
    return min(s0, s1) > _ContactDistance || max(s0, s1) < -_ContactDistance || any(high < min(from, to)) || any(low > max(from, to));
}

#endif
