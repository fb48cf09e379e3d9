using System;
using System.Globalization;
using System.Runtime.InteropServices;

namespace UnityEngine;

[StructLayout(LayoutKind.Sequential)]
public struct Rect : IEquatable<Rect>, IFormattable
{
    float m_XMin;
    float m_YMin;
    float m_Width;
    float m_Height;

    public Rect(float x, float y, float width, float height) { m_XMin = x; m_YMin = y; m_Width = width; m_Height = height; }
    public Rect(Vector2 position, Vector2 size) : this(position.x, position.y, size.x, size.y) { }
    public Rect(Rect source) { this = source; }

    public static Rect zero => default;
    public static Rect MinMaxRect(float xmin, float ymin, float xmax, float ymax) => new(xmin, ymin, xmax - xmin, ymax - ymin);

    public float x { readonly get => m_XMin; set => m_XMin = value; }
    public float y { readonly get => m_YMin; set => m_YMin = value; }
    public float width { readonly get => m_Width; set => m_Width = value; }
    public float height { readonly get => m_Height; set => m_Height = value; }
    public float xMin { readonly get => m_XMin; set { float end = xMax; m_XMin = value; m_Width = end - value; } }
    public float yMin { readonly get => m_YMin; set { float end = yMax; m_YMin = value; m_Height = end - value; } }
    public float xMax { readonly get => m_XMin + m_Width; set => m_Width = value - m_XMin; }
    public float yMax { readonly get => m_YMin + m_Height; set => m_Height = value - m_YMin; }
    public Vector2 position { get => new(m_XMin, m_YMin); set { m_XMin = value.x; m_YMin = value.y; } }
    public Vector2 size { get => new(m_Width, m_Height); set { m_Width = value.x; m_Height = value.y; } }
    public Vector2 center { get => new(m_XMin + m_Width / 2f, m_YMin + m_Height / 2f); set { m_XMin = value.x - m_Width / 2f; m_YMin = value.y - m_Height / 2f; } }
    public Vector2 min { get => new(xMin, yMin); set { xMin = value.x; yMin = value.y; } }
    public Vector2 max { get => new(xMax, yMax); set { xMax = value.x; yMax = value.y; } }

    public void Set(float x, float y, float width, float height) => this = new Rect(x, y, width, height);

    public bool Contains(Vector2 point) => point.x >= xMin && point.x < xMax && point.y >= yMin && point.y < yMax;
    public bool Contains(Vector3 point) => Contains((Vector2)point);
    public bool Contains(Vector3 point, bool allowInverse) => allowInverse ? Ordered().Contains(point) : Contains(point);

    public bool Overlaps(Rect other) => other.xMax > xMin && other.xMin < xMax && other.yMax > yMin && other.yMin < yMax;
    public bool Overlaps(Rect other, bool allowInverse) => allowInverse ? Ordered().Overlaps(other.Ordered()) : Overlaps(other);

    Rect Ordered() => MinMaxRect(MathF.Min(xMin, xMax), MathF.Min(yMin, yMax), MathF.Max(xMin, xMax), MathF.Max(yMin, yMax));

    public static Vector2 NormalizedToPoint(Rect rectangle, Vector2 normalizedRectCoordinates) =>
        new(Mathf.Lerp(rectangle.x, rectangle.xMax, normalizedRectCoordinates.x), Mathf.Lerp(rectangle.y, rectangle.yMax, normalizedRectCoordinates.y));

    public static Vector2 PointToNormalized(Rect rectangle, Vector2 point) =>
        new(Mathf.InverseLerp(rectangle.x, rectangle.xMax, point.x), Mathf.InverseLerp(rectangle.y, rectangle.yMax, point.y));

    public static bool operator ==(Rect lhs, Rect rhs) =>
        lhs.m_XMin == rhs.m_XMin && lhs.m_YMin == rhs.m_YMin && lhs.m_Width == rhs.m_Width && lhs.m_Height == rhs.m_Height;
    public static bool operator !=(Rect lhs, Rect rhs) => !(lhs == rhs);

    public readonly bool Equals(Rect other) => this == other;
    public override readonly bool Equals(object? other) => other is Rect r && Equals(r);
    public override readonly int GetHashCode() => HashCode.Combine(m_XMin, m_YMin, m_Width, m_Height);
    public override readonly string ToString() => ToString(null, null);
    public readonly string ToString(string? format) => ToString(format, null);

    public readonly string ToString(string? format, IFormatProvider? formatProvider)
    {
        if (string.IsNullOrEmpty(format)) format = "F2";
        formatProvider ??= CultureInfo.InvariantCulture.NumberFormat;
        return $"(x:{x.ToString(format, formatProvider)}, y:{y.ToString(format, formatProvider)}, width:{width.ToString(format, formatProvider)}, height:{height.ToString(format, formatProvider)})";
    }
}
