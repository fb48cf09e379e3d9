using System;

namespace UnityEngine;

public partial struct Vector3
{
    public static Vector3 Project(Vector3 vector, Vector3 onNormal)
    {
        float square = onNormal.sqrMagnitude;
        return square < Mathf.Epsilon ? zero : onNormal * (Dot(vector, onNormal) / square);
    }

    public static Vector3 ProjectOnPlane(Vector3 vector, Vector3 planeNormal) => vector - Project(vector, planeNormal);

    public static Vector3 Reflect(Vector3 inDirection, Vector3 inNormal) => inDirection - 2f * Dot(inNormal, inDirection) * inNormal;

    public static float Angle(Vector3 from, Vector3 to)
    {
        float denominator = MathF.Sqrt(from.sqrMagnitude * to.sqrMagnitude);
        return denominator < kEpsilonNormalSqrt ? 0f : MathF.Acos(Mathf.Clamp(Dot(from, to) / denominator, -1f, 1f)) * Mathf.Rad2Deg;
    }

    public static float SignedAngle(Vector3 from, Vector3 to, Vector3 axis) => Angle(from, to) * Mathf.Sign(Dot(axis, Cross(from, to)));

    public static Vector3 ClampMagnitude(Vector3 vector, float maxLength)
    {
        float length = vector.magnitude;
        return length > maxLength ? vector / length * maxLength : vector;
    }

    public static Vector3 MoveTowards(Vector3 current, Vector3 target, float maxDistanceDelta)
    {
        Vector3 to = target - current;
        float distance = to.magnitude;
        return distance == 0f || (maxDistanceDelta >= 0f && distance <= maxDistanceDelta) ? target : current + to / distance * maxDistanceDelta;
    }

    public static void OrthoNormalize(ref Vector3 normal, ref Vector3 tangent)
    {
        normal = normal.sqrMagnitude > 0f ? normal.normalized : right;
        tangent -= normal * Dot(normal, tangent);
        tangent = tangent.magnitude > kEpsilon ? tangent.normalized : AnyPerpendicular(normal);
    }

    public static void OrthoNormalize(ref Vector3 normal, ref Vector3 tangent, ref Vector3 binormal)
    {
        OrthoNormalize(ref normal, ref tangent);
        binormal -= normal * Dot(normal, binormal) + tangent * Dot(tangent, binormal);
        binormal = binormal.magnitude > kEpsilon ? binormal.normalized : Cross(normal, tangent);
    }

    public static Vector3 Slerp(Vector3 a, Vector3 b, float t) => SlerpUnclamped(a, b, Mathf.Clamp01(t));

    public static Vector3 SlerpUnclamped(Vector3 a, Vector3 b, float t)
    {
        float lengthA = a.magnitude, lengthB = b.magnitude;
        if (lengthA < kEpsilon || lengthB < kEpsilon) return LerpUnclamped(a, b, t);
        Vector3 u = a / lengthA, v = b / lengthB;
        float cosine = Mathf.Clamp(Dot(u, v), -1f, 1f);
        if (cosine > 1f - kEpsilon) return LerpUnclamped(a, b, t);
        Vector3 axis = cosine < -1f + kEpsilon ? AnyPerpendicular(u) : Cross(u, v).normalized;
        Vector3 direction = Quaternion.AngleAxis(MathF.Acos(cosine) * Mathf.Rad2Deg * t, axis) * u;
        return direction * Mathf.LerpUnclamped(lengthA, lengthB, t);
    }

    public static Vector3 RotateTowards(Vector3 current, Vector3 target, float maxRadiansDelta, float maxMagnitudeDelta)
    {
        float currentLength = current.magnitude, targetLength = target.magnitude;
        if (currentLength < kEpsilon || targetLength < kEpsilon) return MoveTowards(current, target, maxMagnitudeDelta);
        Vector3 u = current / currentLength, v = target / targetLength;
        float angle = MathF.Acos(Mathf.Clamp(Dot(u, v), -1f, 1f));
        Vector3 axis = angle > MathF.PI - 1e-3f ? AnyPerpendicular(u) : Cross(u, v).normalized;
        float step = Mathf.Min(maxRadiansDelta, angle);
        Vector3 direction = angle < 1e-6f ? v : Quaternion.AngleAxis(step * Mathf.Rad2Deg, axis) * u;
        return direction * Mathf.MoveTowards(currentLength, targetLength, maxMagnitudeDelta);
    }

    public static Vector3 SmoothDamp(Vector3 current, Vector3 target, ref Vector3 currentVelocity, float smoothTime, float maxSpeed) =>
        SmoothDamp(current, target, ref currentVelocity, smoothTime, maxSpeed, Time.deltaTime);

    public static Vector3 SmoothDamp(Vector3 current, Vector3 target, ref Vector3 currentVelocity, float smoothTime) =>
        SmoothDamp(current, target, ref currentVelocity, smoothTime, Mathf.Infinity, Time.deltaTime);

    // Critically damped spring, Game Programming Gems 4, chapter 1.10.
    public static Vector3 SmoothDamp(Vector3 current, Vector3 target, ref Vector3 currentVelocity, float smoothTime, float maxSpeed, float deltaTime)
    {
        smoothTime = Mathf.Max(0.0001f, smoothTime);
        float omega = 2f / smoothTime;
        float x = omega * deltaTime;
        float decay = 1f / (1f + x + 0.48f * x * x + 0.235f * x * x * x);
        Vector3 goal = target;
        Vector3 change = ClampMagnitude(current - target, maxSpeed * smoothTime);
        target = current - change;
        Vector3 temp = (currentVelocity + omega * change) * deltaTime;
        currentVelocity = (currentVelocity - omega * temp) * decay;
        Vector3 output = target + (change + temp) * decay;
        if (Dot(goal - current, output - goal) > 0f)
        {
            output = goal;
            currentVelocity = zero;
        }
        return output;
    }

    static Vector3 AnyPerpendicular(Vector3 unit)
    {
        Vector3 other = MathF.Abs(unit.z) > 0.7071068f ? new Vector3(0f, -unit.z, unit.y) : new Vector3(-unit.y, unit.x, 0f);
        return other.normalized;
    }
}
