#ifndef SPHFLUID_TRIANGLE_SWEEP
#define SPHFLUID_TRIANGLE_SWEEP

// Motion of a point against one triangle, by separating planes. For any unit n, min_i (x - v_i).n over the corners is a lower
// bound of the distance; where it is positive at both ends of a segment, the segment misses the triangle, its edges and its
// corners. A badly rounded n proves less, never wrongly. The same holds where the corners go straight too: (x - v_i).n is linear in
// time for a constant n.
#include "../../Collision/Bodies.hlsl"

float _ContactDistance;  // r_c: where particles come to rest, 0.1 dx
float _SweepDistance;    // rho = 0.9 r_c: no motion is let nearer
float _ContactFloor;     // r_f: gaps do not go below
float _ContactTolerance; // of r_c at rest

#define SWEEP_ADVANCES 7

// Times of segments that are proved free. One number in place of flags: on some GPUs each flag that lives through a loop costs two of the
// few scalar registers.
#define SWEEP_SOFT 2.0 // but it ends nearer than the contact distance
#define SWEEP_FREE 3.0

bool Hits(float time)
{
    return time <= 1.0;
}

struct Gap
{
    float Value;   // certified lower bound of the distance
    float3 Normal; // that proves it
};

struct Sweep
{
    float Time;    // proved free up to here, 0 to 1, where the whole segment is not; else SWEEP_SOFT or SWEEP_FREE
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
    const bool cornerA = d1 <= 0.0 && d2 <= 0.0;
    const bool cornerB = d3 >= 0.0 && d4 <= d3;
    const bool cornerC = d6 >= 0.0 && d5 <= d6;
    const bool edgeAB = d1 * d4 - d3 * d2 <= 0.0 && d1 >= 0.0 && d3 <= 0.0;
    const bool edgeAC = d5 * d2 - d1 * d6 <= 0.0 && d2 >= 0.0 && d6 <= 0.0;
    const bool edgeBC = d3 * d6 - d5 * d4 <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0;
    // From a corner where an edge's nearest point is that corner, so that one code serves corners and edges.
    const bool atA = cornerA;
    const bool atB = !atA && cornerB;
    const bool atC = !atA && !atB && cornerC && !edgeAB;
    const bool alongAB = atA || !atB && !atC && edgeAB;
    const bool alongAC = !alongAB && !atB && !atC && edgeAC;
    const bool alongBC = atB || !alongAB && !atC && !alongAC && edgeBC;
    float3 r;
    [branch]
    if (alongAB || alongAC || alongBC || atC)
    {
        const float3 from = atC ? tri.C : (alongBC ? tri.B : tri.A);
        const float3 to = atC ? tri.A : (alongAB ? tri.B : tri.C);
        r = FromEdge(x, from, to);
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
        float3 direction = dot(x - tri.A, face) < 0.0 ? -face : face;
        float3 from = tri.A;
        float3 to = tri.B;
        [loop]
        for (int k = 0; k < 4; k++)
        {
            Better(x, tri, direction, gap);
            direction = FromEdge(x, from, to);
            from = to;
            to = k == 0 ? tri.C : tri.A;
        }
        gap.Value = gap.Value < -1e29 ? 0.0 : gap.Value;
    }
    return gap;
}

// A triangle during a step: its corners go straight from where they are at the start to where they are at the end.
struct SweptTriangle
{
    BodyTriangle Start;
#if defined(FLUID_STRETCHED_BODIES)
    BodyTriangle End;
#endif
};

SweptTriangle SweepOf(uint index, BodyPose start, BodyPose end)
{
    SweptTriangle swept;
    swept.Start = TriangleAt(start, index);
#if defined(FLUID_STRETCHED_BODIES)
    swept.End = TriangleAt(end, index);
#endif
    return swept;
}

BodyTriangle EndOf(SweptTriangle swept)
{
#if defined(FLUID_STRETCHED_BODIES)
    return swept.End;
#else
    return swept.Start;
#endif
}

BodyTriangle TriangleAfter(SweptTriangle swept, float time)
{
    BodyTriangle tri = swept.Start;
#if defined(FLUID_STRETCHED_BODIES)
    tri.A = swept.Start.A * (1.0 - time) + swept.End.A * time;
    tri.B = swept.Start.B * (1.0 - time) + swept.End.B * time;
    tri.C = swept.Start.C * (1.0 - time) + swept.End.C * time;
#endif
    return tri;
}

// How fast the corners come nearer along n, over the step.
float3 Approaches(SweptTriangle swept, float3 displacement, float3 n)
{
#if defined(FLUID_STRETCHED_BODIES)
    return float3(dot(swept.End.A - swept.Start.A - displacement, n), dot(swept.End.B - swept.Start.B - displacement, n),
        dot(swept.End.C - swept.Start.C - displacement, n));
#else
    return -dot(displacement, n);
#endif
}

float Largest(float3 v)
{
    return max(v.x, max(v.y, v.z));
}

// Time until the first corner is at a distance along the gap's normal.
float TimeTo(float3 x, BodyTriangle tri, Gap gap, float3 approaches, float distance)
{
#if defined(FLUID_STRETCHED_BODIES)
    const float3 gaps = float3(dot(x - tri.A, gap.Normal), dot(x - tri.B, gap.Normal), dot(x - tri.C, gap.Normal));
    const float3 times = approaches > 0.0 ? max(gaps - distance, 0.0) / max(approaches, 1e-30) : float3(1.0, 1.0, 1.0);
    return min(times.x, min(times.y, times.z));
#else
    return (gap.Value - distance) / approaches.x;
#endif
}

// Newton's steps on the gap, a minimum of functions that are linear in time for a fixed normal; they never overshoot. The last of
// them is not tried: its place and normal are the hit's. After a free sweep the gap at the end is looked at.
// cap: relaxes the distance where the particle is nearer already.
Sweep SweepTriangle(float3 from, float3 to, SweptTriangle swept, float cap)
{
    Sweep sweep = (Sweep)0;
    const float3 displacement = to - from;
    BodyTriangle tri = swept.Start;
    float3 x = from;
    float distance = 0.0;
    bool done = false;
    [loop]
    for (int i = 0; i < SWEEP_ADVANCES + 2 && !done; i++)
    {
        const Gap gap = GapOf(x, tri);
        const float3 approaches = Approaches(swept, displacement, gap.Normal);
        if (!Hits(sweep.Time))
        {
            done = true;
            if (gap.Value < _ContactDistance - _ContactTolerance && Largest(approaches) >= 0.0)
            {
                sweep.Time = SWEEP_SOFT;
                sweep.Normal = gap.Normal;
                sweep.EndGap = gap.Value;
            }
        }
        else
        {
            if (i == 0)
            {
                sweep.StartGap = gap.Value;
                distance = min(_SweepDistance, max(_ContactFloor, 0.99 * min(gap.Value, cap)));
            }
            sweep.Normal = gap.Normal;
            sweep.EndGap = Support(to, EndOf(swept), gap.Normal);
            const bool last = i == SWEEP_ADVANCES;
            if (!last && (sweep.EndGap >= distance || Largest(approaches) <= 0.0))
            {
                sweep.Time = SWEEP_FREE;
                done = sweep.EndGap >= _ContactDistance - _ContactTolerance;
                x = to;
                tri = EndOf(swept);
            }
            else if (last || gap.Value - distance <= 0.02 * distance)
            {
                done = true;
            }
            else
            {
                sweep.Time = min(1.0, sweep.Time + TimeTo(x, tri, gap, approaches, distance));
                x = from + displacement * sweep.Time;
                tri = TriangleAfter(swept, sweep.Time);
            }
        }
    }
    return sweep;
}

// Whether a displacement of the rigid frame cannot come near the triangle.
bool PassesBy(float3 from, float3 to, SweptTriangle swept)
{
    const BodyTriangle start = swept.Start;
    const BodyTriangle end = EndOf(swept);
    const float3 n = NormalOf(start);
    const float s0 = dot(from - start.A, n);
    const float s1 = dot(to - end.A, n);
    float low1 = s1;
    float high1 = s1;
    float3 low = min(start.A, min(start.B, start.C));
    float3 high = max(start.A, max(start.B, start.C));
#if defined(FLUID_STRETCHED_BODIES)
    const float s2 = dot(to - end.B, n);
    const float s3 = dot(to - end.C, n);
    low1 = min(s1, min(s2, s3));
    high1 = max(s1, max(s2, s3));
    low = min(low, min(end.A, min(end.B, end.C)));
    high = max(high, max(end.A, max(end.B, end.C)));
#endif
    low -= _ContactDistance;
    high += _ContactDistance;
    return min(s0, low1) > _ContactDistance || max(s0, high1) < -_ContactDistance || any(high < min(from, to)) || any(low > max(from, to));
}

#endif
