using System;

namespace UnityEngine;

public partial struct Mathf
{
    public static float Lerp(float a, float b, float t) => a + (b - a) * Clamp01(t);
    public static float LerpUnclamped(float a, float b, float t) => a + (b - a) * t;
    public static float InverseLerp(float a, float b, float value) => a != b ? Clamp01((value - a) / (b - a)) : 0f;
    public static float Repeat(float t, float length) => Clamp(t - Floor(t / length) * length, 0f, length);

    public static float PingPong(float t, float length)
    {
        t = Repeat(t, length * 2f);
        return length - Abs(t - length);
    }

    public static float DeltaAngle(float current, float target)
    {
        float delta = Repeat(target - current, 360f);
        return delta > 180f ? delta - 360f : delta;
    }

    public static float LerpAngle(float a, float b, float t)
    {
        float delta = Repeat(b - a, 360f);
        if (delta > 180f) delta -= 360f;
        return a + delta * Clamp01(t);
    }

    public static float MoveTowards(float current, float target, float maxDelta) =>
        Abs(target - current) <= maxDelta ? target : current + Sign(target - current) * maxDelta;

    public static float MoveTowardsAngle(float current, float target, float maxDelta)
    {
        float delta = DeltaAngle(current, target);
        return -maxDelta < delta && delta < maxDelta ? target : MoveTowards(current, current + delta, maxDelta);
    }

    public static float SmoothStep(float from, float to, float t)
    {
        t = Clamp01(t);
        t = -2f * t * t * t + 3f * t * t;
        return to * t + from * (1f - t);
    }

    public static float Gamma(float value, float absmax, float gamma)
    {
        float magnitude = Abs(value);
        if (magnitude > absmax) return value < 0f ? -magnitude : magnitude;
        float result = Pow(magnitude / absmax, gamma) * absmax;
        return value < 0f ? -result : result;
    }

    public static float SmoothDamp(float current, float target, ref float currentVelocity, float smoothTime, float maxSpeed) =>
        SmoothDamp(current, target, ref currentVelocity, smoothTime, maxSpeed, Time.deltaTime);

    public static float SmoothDamp(float current, float target, ref float currentVelocity, float smoothTime) =>
        SmoothDamp(current, target, ref currentVelocity, smoothTime, Infinity, Time.deltaTime);

    // Critically damped spring, Game Programming Gems 4, chapter 1.10.
    public static float SmoothDamp(float current, float target, ref float currentVelocity, float smoothTime, float maxSpeed, float deltaTime)
    {
        smoothTime = Max(0.0001f, smoothTime);
        float omega = 2f / smoothTime;
        float x = omega * deltaTime;
        float decay = 1f / (1f + x + 0.48f * x * x + 0.235f * x * x * x);
        float maxChange = maxSpeed * smoothTime;
        float change = Clamp(current - target, -maxChange, maxChange);
        float goal = target;
        target = current - change;
        float temp = (currentVelocity + omega * change) * deltaTime;
        currentVelocity = (currentVelocity - omega * temp) * decay;
        float output = target + (change + temp) * decay;
        if (goal - current > 0f == output > goal)
        {
            output = goal;
            currentVelocity = deltaTime > 0f ? (output - goal) / deltaTime : 0f;
        }
        return output;
    }

    public static float SmoothDampAngle(float current, float target, ref float currentVelocity, float smoothTime, float maxSpeed) =>
        SmoothDampAngle(current, target, ref currentVelocity, smoothTime, maxSpeed, Time.deltaTime);

    public static float SmoothDampAngle(float current, float target, ref float currentVelocity, float smoothTime) =>
        SmoothDampAngle(current, target, ref currentVelocity, smoothTime, Infinity, Time.deltaTime);

    public static float SmoothDampAngle(float current, float target, ref float currentVelocity, float smoothTime, float maxSpeed, float deltaTime) =>
        SmoothDamp(current, current + DeltaAngle(current, target), ref currentVelocity, smoothTime, maxSpeed, deltaTime);
}
