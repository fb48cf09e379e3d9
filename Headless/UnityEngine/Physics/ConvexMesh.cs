using System;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Nearest point of a closed convex triangle mesh.</summary>
static class ConvexMesh
{
    public static Vector3 ClosestPoint(Vector3[] vertices, int[] triangles, Matrix4x4 toWorld, Vector3 point)
    {
        Vector3[] world = Array.ConvertAll(vertices, v => toWorld.MultiplyPoint3x4(v));
        float facing = toWorld.determinant < 0f ? -1f : 1f;
        bool inside = true;
        float best = float.PositiveInfinity;
        Vector3 nearest = point;
        for (int i = 0; i + 2 < triangles.Length; i += 3)
        {
            Vector3 a = world[triangles[i]], b = world[triangles[i + 1]], c = world[triangles[i + 2]];
            if (facing * Vector3.Dot(Vector3.Cross(b - a, c - a), point - a) > 0f) inside = false;
            Vector3 candidate = OnTriangle(point, a, b, c);
            float distance = (candidate - point).sqrMagnitude;
            if (distance >= best) continue;
            best = distance;
            nearest = candidate;
        }
        return inside ? point : nearest;
    }

    // C. Ericson, Real-Time Collision Detection, 5.1.5.
    static Vector3 OnTriangle(Vector3 p, Vector3 a, Vector3 b, Vector3 c)
    {
        Vector3 ab = b - a, ac = c - a, ap = p - a;
        float d1 = Vector3.Dot(ab, ap), d2 = Vector3.Dot(ac, ap);
        if (d1 <= 0f && d2 <= 0f) return a;
        Vector3 bp = p - b;
        float d3 = Vector3.Dot(ab, bp), d4 = Vector3.Dot(ac, bp);
        if (d3 >= 0f && d4 <= d3) return b;
        float vc = d1 * d4 - d3 * d2;
        if (vc <= 0f && d1 >= 0f && d3 <= 0f) return a + ab * (d1 / (d1 - d3));
        Vector3 cp = p - c;
        float d5 = Vector3.Dot(ab, cp), d6 = Vector3.Dot(ac, cp);
        if (d6 >= 0f && d5 <= d6) return c;
        float vb = d5 * d2 - d1 * d6;
        if (vb <= 0f && d2 >= 0f && d6 <= 0f) return a + ac * (d2 / (d2 - d6));
        float va = d3 * d6 - d5 * d4;
        if (va <= 0f && d4 - d3 >= 0f && d5 - d6 >= 0f) return b + (c - b) * ((d4 - d3) / (d4 - d3 + (d5 - d6)));
        float denominator = 1f / (va + vb + vc);
        return a + ab * (vb * denominator) + ac * (vc * denominator);
    }
}
