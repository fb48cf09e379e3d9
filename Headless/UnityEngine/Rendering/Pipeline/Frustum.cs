using UnityEngine;

namespace Headless.Engine;

/// <summary>The six planes of a view; normals point inwards.</summary>
internal readonly struct Frustum
{
    private readonly Vector4[] planes;

    public Frustum(Matrix4x4 viewProjection)
    {
        Vector4 w = viewProjection.GetRow(3);
        planes =
        [
            w + viewProjection.GetRow(0), w - viewProjection.GetRow(0),
            w + viewProjection.GetRow(1), w - viewProjection.GetRow(1),
            w + viewProjection.GetRow(2), w - viewProjection.GetRow(2),
        ];
    }

    public bool Touches(Bounds bounds)
    {
        Vector3 c = bounds.center;
        Vector3 e = bounds.extents;
        foreach (Vector4 p in planes)
        {
            float distance = (p.x * c.x) + (p.y * c.y) + (p.z * c.z) + p.w;
            float reach = (Mathf.Abs(p.x) * e.x) + (Mathf.Abs(p.y) * e.y) + (Mathf.Abs(p.z) * e.z);
            if (distance + reach < 0f)
            {
                return false;
            }
        }

        return true;
    }
}
