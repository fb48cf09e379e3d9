using UnityEngine;

namespace Headless.Engine;

/// <summary>Boxes in world space.</summary>
internal static class BoundsTransform
{
    public static Bounds ToWorld(Bounds local, in Matrix4x4 matrix)
    {
        Vector3 e = local.extents;
        var extents = new Vector3(
            (Mathf.Abs(matrix.m00) * e.x) + (Mathf.Abs(matrix.m01) * e.y) + (Mathf.Abs(matrix.m02) * e.z),
            (Mathf.Abs(matrix.m10) * e.x) + (Mathf.Abs(matrix.m11) * e.y) + (Mathf.Abs(matrix.m12) * e.z),
            (Mathf.Abs(matrix.m20) * e.x) + (Mathf.Abs(matrix.m21) * e.y) + (Mathf.Abs(matrix.m22) * e.z));
        return new Bounds(matrix.MultiplyPoint3x4(local.center), extents * 2f);
    }
}
