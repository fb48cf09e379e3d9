#ifndef SPHFLUID_TRIANGLE_QUERIES
#define SPHFLUID_TRIANGLE_QUERIES

// Ericson, Real-Time Collision Detection, 5.1.5: by Voronoi regions of the vertices, the edges, the face.
// onFace: the perpendicular from p falls inside the triangle.
float3 ClosestPointOnTriangle(float3 p, float3 a, float3 b, float3 c, out bool onFace)
{
    const float3 ab = b - a;
    const float3 ac = c - a;
    const float3 bc = c - b;
    const float3 ap = p - a;
    const float3 bp = p - b;
    const float3 cp = p - c;
    const float d1 = dot(ab, ap);
    const float d2 = dot(ac, ap);
    const float d3 = dot(ab, bp);
    const float d4 = dot(ac, bp);
    const float d5 = dot(ab, cp);
    const float d6 = dot(ac, cp);
    const float va = d3 * d6 - d5 * d4;
    const float vb = d5 * d2 - d1 * d6;
    const float vc = d1 * d4 - d3 * d2;
    const float e = d4 - d3;
    const float f = d5 - d6;
    float3 closest = a;
    onFace = false;
    if (d1 <= 0.0 && d2 <= 0.0)
    {
        closest = a;
    }
    else if (d3 >= 0.0 && d4 <= d3)
    {
        closest = b;
    }
    else if (d6 >= 0.0 && d5 <= d6)
    {
        closest = c;
    }
    else if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
    {
        closest = a + ab * (d1 / (d1 - d3));
    }
    else if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
    {
        closest = a + ac * (d2 / (d2 - d6));
    }
    else if (va <= 0.0 && e >= 0.0 && f >= 0.0)
    {
        closest = b + bc * (e / (e + f));
    }
    else
    {
        const float scale = 1.0 / (va + vb + vc);
        closest = a + ab * (vb * scale) + ac * (vc * scale);
        onFace = true;
    }
    return closest;
}

// Moller and Trumbore, reference [15] of the thesis, from either side: the fraction of the segment from p along move
// at which it intersects the triangle, 2 where it does not.
float SegmentTriangle(float3 p, float3 move, float3 a, float3 b, float3 c)
{
    const float3 ab = b - a;
    const float3 ac = c - a;
    const float3 h = cross(move, ac);
    const float determinant = dot(ab, h);
    float fraction = 2.0;
    if (abs(determinant) > 1e-30)
    {
        const float3 s = p - a;
        const float3 q = cross(s, ab);
        const float u = dot(s, h) / determinant;
        const float v = dot(move, q) / determinant;
        const float t = dot(ac, q) / determinant;
        if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t >= 0.0 && t <= 1.0)
        {
            fraction = t;
        }
    }
    return fraction;
}

#endif
