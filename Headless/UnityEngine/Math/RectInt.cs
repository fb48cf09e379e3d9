using System;
using System.Runtime.InteropServices;

namespace UnityEngine;

[StructLayout(LayoutKind.Sequential)]
public struct RectInt : IEquatable<RectInt>, IFormattable
{
    int m_XMin;
    int m_YMin;
    int m_Width;
    int m_Height;

    public RectInt(int xMin, int yMin, int width, int height) { m_XMin = xMin; m_YMin = yMin; m_Width = width; m_Height = height; }
    public RectInt(Vector2Int position, Vector2Int size) : this(position.x, position.y, size.x, size.y) { }

    public int x { readonly get => m_XMin; set => m_XMin = value; }
    public int y { readonly get => m_YMin; set => m_YMin = value; }
    public int width { readonly get => m_Width; set => m_Width = value; }
    public int height { readonly get => m_Height; set => m_Height = value; }
    public int xMin { readonly get => Math.Min(m_XMin, m_XMin + m_Width); set { int end = xMax; m_XMin = value; m_Width = end - value; } }
    public int yMin { readonly get => Math.Min(m_YMin, m_YMin + m_Height); set { int end = yMax; m_YMin = value; m_Height = end - value; } }
    public int xMax { readonly get => Math.Max(m_XMin, m_XMin + m_Width); set => m_Width = value - m_XMin; }
    public int yMax { readonly get => Math.Max(m_YMin, m_YMin + m_Height); set => m_Height = value - m_YMin; }
    public Vector2Int position { get => new(m_XMin, m_YMin); set { m_XMin = value.x; m_YMin = value.y; } }
    public Vector2Int size { get => new(m_Width, m_Height); set { m_Width = value.x; m_Height = value.y; } }
    public Vector2Int min { get => new(xMin, yMin); set { xMin = value.x; yMin = value.y; } }
    public Vector2Int max { get => new(xMax, yMax); set { xMax = value.x; yMax = value.y; } }
    public Vector2 center => new(x + m_Width / 2f, y + m_Height / 2f);

    public void SetMinMax(Vector2Int minPosition, Vector2Int maxPosition) { min = minPosition; max = maxPosition; }
    public bool Contains(Vector2Int position) => position.x >= xMin && position.y >= yMin && position.x < xMax && position.y < yMax;
    public bool Overlaps(RectInt other) => other.xMin < xMax && other.xMax > xMin && other.yMin < yMax && other.yMax > yMin;

    public void ClampToBounds(RectInt bounds)
    {
        position = Vector2Int.Max(Vector2Int.Min(bounds.max, position), bounds.min);
        size = Vector2Int.Min(bounds.max - position, size);
    }

    public readonly bool Equals(RectInt other) => m_XMin == other.m_XMin && m_YMin == other.m_YMin && m_Width == other.m_Width && m_Height == other.m_Height;
    public override readonly string ToString() => ToString(null, null);
    public readonly string ToString(string? format) => ToString(format, null);
    public readonly string ToString(string? format, IFormatProvider? formatProvider)
    {
        formatProvider ??= System.Globalization.CultureInfo.InvariantCulture.NumberFormat;
        return $"(x:{x.ToString(format, formatProvider)}, y:{y.ToString(format, formatProvider)}, width:{width.ToString(format, formatProvider)}, height:{height.ToString(format, formatProvider)})";
    }
}
