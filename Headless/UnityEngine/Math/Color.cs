using System;
using System.Globalization;
using System.Runtime.InteropServices;

namespace UnityEngine;

[StructLayout(LayoutKind.Sequential)]
public partial struct Color : IEquatable<Color>, IFormattable
{
    public float r;
    public float g;
    public float b;
    public float a;

    public Color(float r, float g, float b, float a) { this.r = r; this.g = g; this.b = b; this.a = a; }
    public Color(float r, float g, float b) : this(r, g, b, 1f) { }

    public float this[int index]
    {
        readonly get => index switch { 0 => r, 1 => g, 2 => b, 3 => a, _ => throw new IndexOutOfRangeException($"Invalid Color index({index})!") };
        set
        {
            switch (index)
            {
                case 0: r = value; break;
                case 1: g = value; break;
                case 2: b = value; break;
                case 3: a = value; break;
                default: throw new IndexOutOfRangeException($"Invalid Color index({index})!");
            }
        }
    }

    public static Color red => new(1f, 0f, 0f, 1f);
    public static Color green => new(0f, 1f, 0f, 1f);
    public static Color blue => new(0f, 0f, 1f, 1f);
    public static Color white => new(1f, 1f, 1f, 1f);
    public static Color black => new(0f, 0f, 0f, 1f);
    public static Color yellow => new(1f, 235f / 255f, 4f / 255f, 1f);
    public static Color cyan => new(0f, 1f, 1f, 1f);
    public static Color magenta => new(1f, 0f, 1f, 1f);
    public static Color gray => new(0.5f, 0.5f, 0.5f, 1f);
    public static Color grey => gray;
    public static Color clear => new(0f, 0f, 0f, 0f);

    public float grayscale => 0.299f * r + 0.587f * g + 0.114f * b;
    public float maxColorComponent => Mathf.Max(Mathf.Max(r, g), b);
    public Color linear => new(Mathf.GammaToLinearSpace(r), Mathf.GammaToLinearSpace(g), Mathf.GammaToLinearSpace(b), a);
    public Color gamma => new(Mathf.LinearToGammaSpace(r), Mathf.LinearToGammaSpace(g), Mathf.LinearToGammaSpace(b), a);

    public static Color Lerp(Color a, Color b, float t) => LerpUnclamped(a, b, Mathf.Clamp01(t));
    public static Color LerpUnclamped(Color a, Color b, float t) => a + (b - a) * t;

    public static Color operator +(Color a, Color b) => new(a.r + b.r, a.g + b.g, a.b + b.b, a.a + b.a);
    public static Color operator -(Color a, Color b) => new(a.r - b.r, a.g - b.g, a.b - b.b, a.a - b.a);
    public static Color operator *(Color a, Color b) => new(a.r * b.r, a.g * b.g, a.b * b.b, a.a * b.a);
    public static Color operator *(Color a, float b) => new(a.r * b, a.g * b, a.b * b, a.a * b);
    public static Color operator *(float b, Color a) => a * b;
    public static Color operator /(Color a, float b) => new(a.r / b, a.g / b, a.b / b, a.a / b);
    public static bool operator ==(Color lhs, Color rhs) => (Vector4)lhs == (Vector4)rhs;
    public static bool operator !=(Color lhs, Color rhs) => !(lhs == rhs);
    public static implicit operator Vector4(Color c) => new(c.r, c.g, c.b, c.a);
    public static implicit operator Color(Vector4 v) => new(v.x, v.y, v.z, v.w);

    public readonly bool Equals(Color other) => r.Equals(other.r) && g.Equals(other.g) && b.Equals(other.b) && a.Equals(other.a);
    public override readonly bool Equals(object? other) => other is Color c && Equals(c);
    public override readonly int GetHashCode() => ((Vector4)this).GetHashCode();
    public override readonly string ToString() => ToString(null, null);
    public readonly string ToString(string? format) => ToString(format, null);
    public readonly string ToString(string? format, IFormatProvider? formatProvider) =>
        "RGBA" + Formatting.Tuple(string.IsNullOrEmpty(format) ? "F3" : format, formatProvider ?? CultureInfo.InvariantCulture.NumberFormat, r, g, b, a);
}
