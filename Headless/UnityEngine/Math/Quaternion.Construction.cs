using System;

namespace UnityEngine;

public partial struct Quaternion
{
    public static Quaternion AngleAxis(float angle, Vector3 axis)
    {
        float length = axis.magnitude;
        if (length < Vector3.kEpsilon) return identity;
        float half = angle * Mathf.Deg2Rad * 0.5f;
        Vector3 v = axis * (MathF.Sin(half) / length);
        return new Quaternion(v.x, v.y, v.z, MathF.Cos(half));
    }

    public void ToAngleAxis(out float angle, out Vector3 axis)
    {
        Quaternion q = Normalize(this);
        float sine = MathF.Sqrt(q.x * q.x + q.y * q.y + q.z * q.z);
        angle = 2f * MathF.Atan2(sine, q.w) * Mathf.Rad2Deg;
        axis = sine < kEpsilon ? Vector3.right : new Vector3(q.x / sine, q.y / sine, q.z / sine);
    }

    /// <summary>Rotates about z, then x, then y: the product y * x * z.</summary>
    public static Quaternion Euler(float x, float y, float z)
    {
        float hx = x * Mathf.Deg2Rad * 0.5f, hy = y * Mathf.Deg2Rad * 0.5f, hz = z * Mathf.Deg2Rad * 0.5f;
        float sx = MathF.Sin(hx), cx = MathF.Cos(hx), sy = MathF.Sin(hy), cy = MathF.Cos(hy), sz = MathF.Sin(hz), cz = MathF.Cos(hz);
        return new Quaternion(
            cy * sx * cz + sy * cx * sz,
            sy * cx * cz - cy * sx * sz,
            cy * cx * sz - sy * sx * cz,
            cy * cx * cz + sy * sx * sz);
    }

    public static Quaternion Euler(Vector3 euler) => Euler(euler.x, euler.y, euler.z);

    static Vector3 ToEulerDegrees(Quaternion q)
    {
        q = Normalize(q);
        float sine = 2f * (q.w * q.x - q.y * q.z);
        Vector3 radians;
        if (MathF.Abs(sine) > 0.999999f)
        {
            radians = new Vector3(MathF.CopySign(MathF.PI / 2f, sine), 2f * MathF.Atan2(q.y, q.w), 0f);
        }
        else
        {
            radians = new Vector3(
                MathF.Asin(sine),
                MathF.Atan2(2f * (q.x * q.z + q.w * q.y), 1f - 2f * (q.x * q.x + q.y * q.y)),
                MathF.Atan2(2f * (q.x * q.y + q.w * q.z), 1f - 2f * (q.x * q.x + q.z * q.z)));
        }
        return new Vector3(Positive(radians.x), Positive(radians.y), Positive(radians.z));
    }

    static float Positive(float radians)
    {
        float degrees = radians * Mathf.Rad2Deg;
        const float tolerance = -0.0001f * Mathf.Rad2Deg;
        if (degrees < tolerance) return degrees + 360f;
        return degrees > 360f + tolerance ? degrees - 360f : degrees;
    }

    public static Quaternion LookRotation(Vector3 forward) => LookRotation(forward, Vector3.up);

    public static Quaternion LookRotation(Vector3 forward, Vector3 upwards)
    {
        if (forward.sqrMagnitude < Mathf.Epsilon)
        {
            Debug.Log("Look rotation viewing vector is zero");
            return identity;
        }
        Vector3 z = forward / forward.magnitude;
        Vector3 x = Vector3.Cross(upwards, z);
        if (x.magnitude < Vector3.kEpsilon) return FromToRotation(Vector3.forward, z);
        x = x / x.magnitude;
        return FromBasis(x, Vector3.Cross(z, x), z);
    }

    public void SetLookRotation(Vector3 view) => this = LookRotation(view, Vector3.up);
    public void SetLookRotation(Vector3 view, Vector3 up) => this = LookRotation(view, up);

    public static Quaternion FromToRotation(Vector3 fromDirection, Vector3 toDirection)
    {
        float lengths = MathF.Sqrt(fromDirection.sqrMagnitude * toDirection.sqrMagnitude);
        if (lengths < Mathf.Epsilon) return identity;
        float w = lengths + Vector3.Dot(fromDirection, toDirection);
        if (w < 1e-6f * lengths)
        {
            Vector3 axis = Vector3.Cross(Vector3.right, fromDirection);
            if (axis.sqrMagnitude < 1e-6f * fromDirection.sqrMagnitude) axis = Vector3.Cross(Vector3.up, fromDirection);
            return AngleAxis(180f, axis);
        }
        Vector3 cross = Vector3.Cross(fromDirection, toDirection);
        return Normalize(new Quaternion(cross.x, cross.y, cross.z, w));
    }

    public void SetFromToRotation(Vector3 fromDirection, Vector3 toDirection) => this = FromToRotation(fromDirection, toDirection);

    // Largest-component form, S. W. Shepperd 1978.
    internal static Quaternion FromBasis(Vector3 x, Vector3 y, Vector3 z)
    {
        float trace = x.x + y.y + z.z;
        if (trace > 0f)
        {
            float s = MathF.Sqrt(trace + 1f) * 2f;
            return Normalize(new Quaternion((y.z - z.y) / s, (z.x - x.z) / s, (x.y - y.x) / s, 0.25f * s));
        }
        if (x.x > y.y && x.x > z.z)
        {
            float s = MathF.Sqrt(1f + x.x - y.y - z.z) * 2f;
            return Normalize(new Quaternion(0.25f * s, (y.x + x.y) / s, (z.x + x.z) / s, (y.z - z.y) / s));
        }
        if (y.y > z.z)
        {
            float s = MathF.Sqrt(1f + y.y - x.x - z.z) * 2f;
            return Normalize(new Quaternion((y.x + x.y) / s, 0.25f * s, (z.y + y.z) / s, (z.x - x.z) / s));
        }
        float t = MathF.Sqrt(1f + z.z - x.x - y.y) * 2f;
        return Normalize(new Quaternion((z.x + x.z) / t, (z.y + y.z) / t, 0.25f * t, (x.y - y.x) / t));
    }

    public static Quaternion Slerp(Quaternion a, Quaternion b, float t) => SlerpUnclamped(a, b, Mathf.Clamp01(t));

    public static Quaternion SlerpUnclamped(Quaternion a, Quaternion b, float t)
    {
        float dot = Dot(a, b);
        float sign = dot < 0f ? -1f : 1f;
        dot = MathF.Abs(dot);
        if (dot > 0.9995f) return LerpUnclamped(a, b, t);
        float angle = MathF.Acos(dot), sine = MathF.Sin(angle);
        float u = MathF.Sin(angle * (1f - t)) / sine, v = sign * MathF.Sin(angle * t) / sine;
        return new Quaternion(a.x * u + b.x * v, a.y * u + b.y * v, a.z * u + b.z * v, a.w * u + b.w * v);
    }

    public static Quaternion Lerp(Quaternion a, Quaternion b, float t) => LerpUnclamped(a, b, Mathf.Clamp01(t));

    public static Quaternion LerpUnclamped(Quaternion a, Quaternion b, float t)
    {
        float v = Dot(a, b) < 0f ? -t : t;
        float u = 1f - t;
        return Normalize(new Quaternion(a.x * u + b.x * v, a.y * u + b.y * v, a.z * u + b.z * v, a.w * u + b.w * v));
    }

    public static Quaternion RotateTowards(Quaternion from, Quaternion to, float maxDegreesDelta)
    {
        float angle = Angle(from, to);
        return angle == 0f ? to : SlerpUnclamped(from, to, Mathf.Min(1f, maxDegreesDelta / angle));
    }
}
