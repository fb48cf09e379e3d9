using System;

namespace UnityEngine;

public partial struct Mathf
{
    public const float PI = (float)Math.PI;
    public const float Infinity = float.PositiveInfinity;
    public const float NegativeInfinity = float.NegativeInfinity;
    public const float Deg2Rad = PI / 180f;
    public const float Rad2Deg = 180f / PI;
    public static readonly float Epsilon = float.Epsilon;

    public static float Sin(float f) => MathF.Sin(f);
    public static float Cos(float f) => MathF.Cos(f);
    public static float Tan(float f) => MathF.Tan(f);
    public static float Asin(float f) => MathF.Asin(f);
    public static float Acos(float f) => MathF.Acos(f);
    public static float Atan(float f) => MathF.Atan(f);
    public static float Atan2(float y, float x) => MathF.Atan2(y, x);
    public static float Sqrt(float f) => MathF.Sqrt(f);
    public static float Abs(float f) => MathF.Abs(f);
    public static int Abs(int value) => Math.Abs(value);
    public static float Pow(float f, float p) => MathF.Pow(f, p);
    public static float Exp(float power) => MathF.Exp(power);
    public static float Log(float f, float p) => (float)Math.Log(f, p);
    public static float Log(float f) => MathF.Log(f);
    public static float Log10(float f) => MathF.Log10(f);
    public static float Ceil(float f) => MathF.Ceiling(f);
    public static float Floor(float f) => MathF.Floor(f);
    public static float Round(float f) => MathF.Round(f);
    public static int CeilToInt(float f) => (int)Math.Ceiling(f);
    public static int FloorToInt(float f) => (int)Math.Floor(f);
    public static int RoundToInt(float f) => (int)Math.Round(f);
    public static float Sign(float f) => f >= 0f ? 1f : -1f;

    public static float Min(float a, float b) => a < b ? a : b;
    public static int Min(int a, int b) => a < b ? a : b;
    public static float Max(float a, float b) => a > b ? a : b;
    public static int Max(int a, int b) => a > b ? a : b;

    public static float Min(params float[] values)
    {
        if (values.Length == 0) return 0f;
        float m = values[0];
        for (int i = 1; i < values.Length; i++) if (values[i] < m) m = values[i];
        return m;
    }

    public static int Min(params int[] values)
    {
        if (values.Length == 0) return 0;
        int m = values[0];
        for (int i = 1; i < values.Length; i++) if (values[i] < m) m = values[i];
        return m;
    }

    public static float Max(params float[] values)
    {
        if (values.Length == 0) return 0f;
        float m = values[0];
        for (int i = 1; i < values.Length; i++) if (values[i] > m) m = values[i];
        return m;
    }

    public static int Max(params int[] values)
    {
        if (values.Length == 0) return 0;
        int m = values[0];
        for (int i = 1; i < values.Length; i++) if (values[i] > m) m = values[i];
        return m;
    }

    public static float Clamp(float value, float min, float max) => value < min ? min : value > max ? max : value;
    public static int Clamp(int value, int min, int max) => value < min ? min : value > max ? max : value;
    public static float Clamp01(float value) => value < 0f ? 0f : value > 1f ? 1f : value;

    public static bool Approximately(float a, float b) =>
        Abs(b - a) < Max(0.000001f * Max(Abs(a), Abs(b)), Epsilon * 8f);

    public static int ClosestPowerOfTwo(int value)
    {
        int next = NextPowerOfTwo(value);
        int previous = next >> 1;
        return value - previous < next - value ? previous : next;
    }

    public static bool IsPowerOfTwo(int value) => (value & (value - 1)) == 0;

    public static int NextPowerOfTwo(int value)
    {
        value -= 1;
        value |= value >> 16;
        value |= value >> 8;
        value |= value >> 4;
        value |= value >> 2;
        value |= value >> 1;
        return value + 1;
    }
}
