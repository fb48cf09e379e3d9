using System;

namespace UnityEngine;

public partial struct Mathf
{
    // IEC 61966-2-1 (sRGB).
    public static float GammaToLinearSpace(float value)
    {
        if (value <= 0.04045f) return value / 12.92f;
        return value < 1f ? Pow((value + 0.055f) / 1.055f, 2.4f) : Pow(value, 2.2f);
    }

    public static float LinearToGammaSpace(float value)
    {
        if (value <= 0f) return 0f;
        if (value <= 0.0031308f) return 12.92f * value;
        return value < 1f ? 1.055f * Pow(value, 1f / 2.4f) - 0.055f : Pow(value, 1f / 2.2f);
    }

    public static ushort FloatToHalf(float val) => BitConverter.HalfToUInt16Bits((Half)val);
    public static float HalfToFloat(ushort val) => (float)BitConverter.UInt16BitsToHalf(val);

    public static float PerlinNoise1D(float x) => PerlinNoise(x, 0f);

    // Improved noise, K. Perlin, SIGGRAPH 2002, mapped to [0, 1].
    public static float PerlinNoise(float x, float y)
    {
        float fx = MathF.Floor(x), fy = MathF.Floor(y);
        int xi = (int)fx & 255, yi = (int)fy & 255;
        x -= fx;
        y -= fy;
        float u = Fade(x), v = Fade(y);
        int a = Permutation[xi] + yi, b = Permutation[(xi + 1) & 255] + yi;
        float lower = LerpUnclamped(Gradient(Permutation[a & 255], x, y), Gradient(Permutation[b & 255], x - 1f, y), u);
        float upper = LerpUnclamped(Gradient(Permutation[(a + 1) & 255], x, y - 1f), Gradient(Permutation[(b + 1) & 255], x - 1f, y - 1f), u);
        return (LerpUnclamped(lower, upper, v) + 0.69f) / (0.793f + 0.69f);
    }

    static float Fade(float t) => t * t * t * (t * (t * 6f - 15f) + 10f);

    static float Gradient(int hash, float x, float y)
    {
        int h = hash & 15;
        float u = h < 8 ? x : y;
        float v = h < 4 ? y : h == 12 || h == 14 ? x : 0f;
        return ((h & 1) == 0 ? u : -u) + ((h & 2) == 0 ? v : -v);
    }

    static readonly byte[] Permutation = CreatePermutation();

    static byte[] CreatePermutation()
    {
        var table = new byte[256];
        for (int i = 0; i < 256; i++) table[i] = (byte)i;
        uint state = 0x9E3779B9;
        for (int i = 255; i > 0; i--)
        {
            state = state * 1664525u + 1013904223u;
            int j = (int)((state >> 8) % (uint)(i + 1));
            (table[i], table[j]) = (table[j], table[i]);
        }
        return table;
    }
}
