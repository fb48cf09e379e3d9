using System;
using UnityEngine;

namespace Headless.Engine;

/// <summary>The planes of a view; normals point inwards.</summary>
internal readonly struct Frustum
{
    private readonly Vector4[] planes;

    /// <summary>Left, right, bottom, top, near and far.</summary>
    public Frustum(Matrix4x4 viewProjection)
    {
        Vector4 w = viewProjection.GetRow(3);
        planes =
        [
            w + viewProjection.GetRow(0), w - viewProjection.GetRow(0),
            w + viewProjection.GetRow(1), w - viewProjection.GetRow(1),
            w + viewProjection.GetRow(2), w - viewProjection.GetRow(2),
        ];
        for (int i = 0; i < planes.Length; i++)
        {
            planes[i] /= Mathf.Max(1e-20f, ((Vector3)planes[i]).magnitude);
        }
    }

    public Frustum(ReadOnlySpan<Vector4> planes) => this.planes = planes.ToArray();

    /// <summary>Of length 1, so that w is a distance.</summary>
    public ReadOnlySpan<Vector4> Planes => planes;

    public bool Touches(Bounds bounds) => Touches(bounds, default);

    /// <summary>Whether a box touches it on its way in a direction.</summary>
    public bool Touches(in Bounds bounds, Vector3 direction)
    {
        Vector3 c = bounds.center;
        Vector3 e = bounds.extents;
        foreach (Vector4 p in planes)
        {
            float reach = (Mathf.Abs(p.x) * e.x) + (Mathf.Abs(p.y) * e.y) + (Mathf.Abs(p.z) * e.z);
            if (Distance(p, c) + reach < 0f && Vector3.Dot(p, direction) <= 0f)
            {
                return false;
            }
        }

        return true;
    }

    public bool Touches(Vector3 center, float radius)
    {
        foreach (Vector4 p in planes)
        {
            if (Distance(p, center) + radius < 0f)
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>The part of it before another plane.</summary>
    public Frustum Before(Vector4 plane) => new([.. planes, plane]);

    private static float Distance(Vector4 p, Vector3 c) => (p.x * c.x) + (p.y * c.y) + (p.z * c.z) + p.w;
}
