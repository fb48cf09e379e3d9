using System;

namespace UnityEngine;

/// <summary>xorshift128 (G. Marsaglia 2003), seeded by the MT19937 initialiser.</summary>
public static class Random
{
    [Serializable]
    public struct State
    {
        internal uint s0;
        internal uint s1;
        internal uint s2;
        internal uint s3;
    }

    static State s_State = Seed(unchecked((uint)Environment.TickCount));

    public static State state { get => s_State; set => s_State = value; }

    public static void InitState(int seed) => s_State = Seed(unchecked((uint)seed));

    public static float value => NextFloat();

    public static float Range(float minInclusive, float maxInclusive)
    {
        float t = NextFloat();
        return t * minInclusive + (1f - t) * maxInclusive;
    }

    public static int Range(int minInclusive, int maxExclusive)
    {
        if (minInclusive == maxExclusive) return minInclusive;
        long low = Math.Min(minInclusive, maxExclusive), high = Math.Max(minInclusive, maxExclusive);
        uint offset = (uint)(Next() % (ulong)(high - low));
        return minInclusive < maxExclusive ? (int)(low + offset) : (int)(minInclusive - offset);
    }

    public static Vector2 insideUnitCircle
    {
        get
        {
            float angle = Range(0f, 2f * Mathf.PI), radius = MathF.Sqrt(NextFloat());
            return new Vector2(MathF.Cos(angle), MathF.Sin(angle)) * radius;
        }
    }

    public static Vector3 onUnitSphere
    {
        get
        {
            float z = Range(-1f, 1f), angle = Range(0f, 2f * Mathf.PI);
            float radius = MathF.Sqrt(MathF.Max(0f, 1f - z * z));
            return new Vector3(radius * MathF.Cos(angle), radius * MathF.Sin(angle), z);
        }
    }

    public static Vector3 insideUnitSphere => onUnitSphere * MathF.Cbrt(NextFloat());

    public static Quaternion rotation =>
        Quaternion.Normalize(new Quaternion(Range(-1f, 1f), Range(-1f, 1f), Range(-1f, 1f), Range(-1f, 1f)));

    // K. Shoemake, Uniform random rotations, Graphics Gems III.
    public static Quaternion rotationUniform
    {
        get
        {
            float u = NextFloat(), a = 2f * Mathf.PI * NextFloat(), b = 2f * Mathf.PI * NextFloat();
            float p = MathF.Sqrt(1f - u), q = MathF.Sqrt(u);
            return new Quaternion(p * MathF.Sin(a), p * MathF.Cos(a), q * MathF.Sin(b), q * MathF.Cos(b));
        }
    }

    public static Color ColorHSV() => ColorHSV(0f, 1f, 0f, 1f, 0f, 1f, 1f, 1f);
    public static Color ColorHSV(float hueMin, float hueMax) => ColorHSV(hueMin, hueMax, 0f, 1f, 0f, 1f, 1f, 1f);

    public static Color ColorHSV(float hueMin, float hueMax, float saturationMin, float saturationMax) =>
        ColorHSV(hueMin, hueMax, saturationMin, saturationMax, 0f, 1f, 1f, 1f);

    public static Color ColorHSV(float hueMin, float hueMax, float saturationMin, float saturationMax, float valueMin, float valueMax) =>
        ColorHSV(hueMin, hueMax, saturationMin, saturationMax, valueMin, valueMax, 1f, 1f);

    public static Color ColorHSV(float hueMin, float hueMax, float saturationMin, float saturationMax, float valueMin, float valueMax, float alphaMin, float alphaMax)
    {
        Color color = Color.HSVToRGB(Mathf.Lerp(hueMin, hueMax, value), Mathf.Lerp(saturationMin, saturationMax, value), Mathf.Lerp(valueMin, valueMax, value), true);
        color.a = Mathf.Lerp(alphaMin, alphaMax, value);
        return color;
    }

    static State Seed(uint seed)
    {
        const uint multiplier = 1812433253u;
        var s = new State { s0 = seed };
        s.s1 = s.s0 * multiplier + 1u;
        s.s2 = s.s1 * multiplier + 1u;
        s.s3 = s.s2 * multiplier + 1u;
        return s;
    }

    static uint Next()
    {
        uint t = s_State.s0;
        t ^= t << 11;
        t ^= t >> 8;
        s_State.s0 = s_State.s1;
        s_State.s1 = s_State.s2;
        s_State.s2 = s_State.s3;
        s_State.s3 = s_State.s3 ^ (s_State.s3 >> 19) ^ t;
        return s_State.s3;
    }

    static float NextFloat() => (Next() & 0x7FFFFFu) / 8388607f;
}
