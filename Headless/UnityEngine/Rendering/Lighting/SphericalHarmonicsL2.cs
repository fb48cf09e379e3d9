using System;
using System.Runtime.CompilerServices;

namespace UnityEngine.Rendering;

/// <summary>Light from all directions: nine coefficients for each of red, green and blue, linear.</summary>
public struct SphericalHarmonicsL2 : IEquatable<SphericalHarmonicsL2>
{
    private const int Bands = 9;

    private Coefficients values;

    public float this[int rgb, int coefficient]
    {
        get => values[Index(rgb, coefficient)];
        set => values[Index(rgb, coefficient)] = value;
    }

    public static SphericalHarmonicsL2 operator *(SphericalHarmonicsL2 lhs, float rhs)
    {
        for (int i = 0; i < 3 * Bands; i++)
        {
            lhs.values[i] *= rhs;
        }

        return lhs;
    }

    public static SphericalHarmonicsL2 operator *(float lhs, SphericalHarmonicsL2 rhs) => rhs * lhs;

    public static SphericalHarmonicsL2 operator +(SphericalHarmonicsL2 lhs, SphericalHarmonicsL2 rhs)
    {
        for (int i = 0; i < 3 * Bands; i++)
        {
            lhs.values[i] += rhs.values[i];
        }

        return lhs;
    }

    public static bool operator ==(SphericalHarmonicsL2 lhs, SphericalHarmonicsL2 rhs) => lhs.Equals(rhs);

    public static bool operator !=(SphericalHarmonicsL2 lhs, SphericalHarmonicsL2 rhs) => !lhs.Equals(rhs);

    public void Clear() => values = default;

    /// <summary>Adds the same light from everywhere.</summary>
    public void AddAmbientLight(Color color)
    {
        for (int c = 0; c < 3; c++)
        {
            this[c, 0] += color[c];
        }
    }

    public readonly bool Equals(SphericalHarmonicsL2 other) => ((ReadOnlySpan<float>)values).SequenceEqual(other.values);

    public override readonly bool Equals(object? other) => other is SphericalHarmonicsL2 probe && Equals(probe);

    public override readonly int GetHashCode()
    {
        var hash = new HashCode();
        foreach (float value in (ReadOnlySpan<float>)values)
        {
            hash.Add(value);
        }

        return hash.ToHashCode();
    }

    private static int Index(int rgb, int coefficient) =>
        rgb is >= 0 and < 3 && coefficient is >= 0 and < Bands
            ? (rgb * Bands) + coefficient
            : throw new IndexOutOfRangeException($"A probe has colors 0 to 2 and coefficients 0 to 8, not [{rgb}, {coefficient}].");

    [InlineArray(3 * Bands)]
    private struct Coefficients
    {
        private float first;
    }
}
