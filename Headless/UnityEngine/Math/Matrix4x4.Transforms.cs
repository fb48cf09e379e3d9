using System;

namespace UnityEngine;

public partial struct Matrix4x4
{
    public static Matrix4x4 Translate(Vector3 vector) =>
        new() { m00 = 1f, m11 = 1f, m22 = 1f, m33 = 1f, m03 = vector.x, m13 = vector.y, m23 = vector.z };

    public static Matrix4x4 Scale(Vector3 vector) => new() { m00 = vector.x, m11 = vector.y, m22 = vector.z, m33 = 1f };

    public static Matrix4x4 Rotate(Quaternion q) => TRS(Vector3.zero, q, Vector3.one);

    public static Matrix4x4 TRS(Vector3 pos, Quaternion q, Vector3 s)
    {
        Vector3 x = q * Vector3.right, y = q * Vector3.up, z = q * Vector3.forward;
        return new Matrix4x4
        {
            m00 = x.x * s.x, m10 = x.y * s.x, m20 = x.z * s.x,
            m01 = y.x * s.y, m11 = y.y * s.y, m21 = y.z * s.y,
            m02 = z.x * s.z, m12 = z.y * s.z, m22 = z.z * s.z,
            m03 = pos.x, m13 = pos.y, m23 = pos.z, m33 = 1f,
        };
    }

    public void SetTRS(Vector3 pos, Quaternion q, Vector3 s) => this = TRS(pos, q, s);

    public bool ValidTRS()
    {
        if (m30 != 0f || m31 != 0f || m32 != 0f || m33 != 1f) return false;
        Vector3 x = GetColumn(0), y = GetColumn(1), z = GetColumn(2);
        const float tolerance = 1e-4f;
        return MathF.Abs(Vector3.Dot(x, y)) <= tolerance * MathF.Max(x.magnitude * y.magnitude, 1e-12f)
            && MathF.Abs(Vector3.Dot(x, z)) <= tolerance * MathF.Max(x.magnitude * z.magnitude, 1e-12f)
            && MathF.Abs(Vector3.Dot(y, z)) <= tolerance * MathF.Max(y.magnitude * z.magnitude, 1e-12f);
    }

    public Quaternion rotation
    {
        get
        {
            Vector3 scale = lossyScale;
            Vector3 x = GetColumn(0), y = GetColumn(1), z = GetColumn(2);
            if (scale.x == 0f || scale.y == 0f || scale.z == 0f) return Quaternion.identity;
            return Quaternion.FromBasis(x / scale.x, y / scale.y, z / scale.z);
        }
    }

    public Vector3 lossyScale
    {
        get
        {
            Vector3 x = GetColumn(0), y = GetColumn(1), z = GetColumn(2);
            bool mirrored = Vector3.Dot(Vector3.Cross(x, y), z) < 0f;
            return new Vector3(mirrored ? -x.magnitude : x.magnitude, y.magnitude, z.magnitude);
        }
    }

    /// <summary>OpenGL clip convention (camera looks along -z, depth -1..1), as the API documents.</summary>
    public static Matrix4x4 Perspective(float fov, float aspect, float zNear, float zFar)
    {
        float cotangent = 1f / MathF.Tan(fov * Mathf.Deg2Rad * 0.5f);
        return new Matrix4x4
        {
            m00 = cotangent / aspect,
            m11 = cotangent,
            m22 = -(zFar + zNear) / (zFar - zNear),
            m23 = -2f * zFar * zNear / (zFar - zNear),
            m32 = -1f,
        };
    }

    public static Matrix4x4 Ortho(float left, float right, float bottom, float top, float zNear, float zFar) => new()
    {
        m00 = 2f / (right - left), m03 = -(right + left) / (right - left),
        m11 = 2f / (top - bottom), m13 = -(top + bottom) / (top - bottom),
        m22 = -2f / (zFar - zNear), m23 = -(zFar + zNear) / (zFar - zNear),
        m33 = 1f,
    };

    public static Matrix4x4 Frustum(float left, float right, float bottom, float top, float zNear, float zFar) => new()
    {
        m00 = 2f * zNear / (right - left), m02 = (right + left) / (right - left),
        m11 = 2f * zNear / (top - bottom), m12 = (top + bottom) / (top - bottom),
        m22 = -(zFar + zNear) / (zFar - zNear), m23 = -2f * zFar * zNear / (zFar - zNear),
        m32 = -1f,
    };

    public static Matrix4x4 Frustum(FrustumPlanes fp) => Frustum(fp.left, fp.right, fp.bottom, fp.top, fp.zNear, fp.zFar);

    public FrustumPlanes decomposeProjection
    {
        get
        {
            bool perspective = m33 == 0f;
            float near = perspective ? m23 / (m22 - 1f) : (m23 + 1f) / m22;
            float far = perspective ? m23 / (m22 + 1f) : (m23 - 1f) / m22;
            float scale = perspective ? near : 1f;
            float shiftX = perspective ? m02 : -m03, shiftY = perspective ? m12 : -m13;
            return new FrustumPlanes
            {
                left = scale * (shiftX - 1f) / m00, right = scale * (shiftX + 1f) / m00,
                bottom = scale * (shiftY - 1f) / m11, top = scale * (shiftY + 1f) / m11,
                zNear = near, zFar = far,
            };
        }
    }

    public static Matrix4x4 LookAt(Vector3 from, Vector3 to, Vector3 up) =>
        TRS(from, Quaternion.LookRotation(to - from, up), Vector3.one);
}
