using System;
using System.Collections;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace UnityEngine;

[StructLayout(LayoutKind.Sequential)]
public struct BoundsInt : IEquatable<BoundsInt>, IFormattable
{
    Vector3Int m_Position;
    Vector3Int m_Size;

    public BoundsInt(int xMin, int yMin, int zMin, int sizeX, int sizeY, int sizeZ)
        : this(new Vector3Int(xMin, yMin, zMin), new Vector3Int(sizeX, sizeY, sizeZ)) { }

    public BoundsInt(Vector3Int position, Vector3Int size) { m_Position = position; m_Size = size; }

    public int x { readonly get => m_Position.x; set => m_Position.x = value; }
    public int y { readonly get => m_Position.y; set => m_Position.y = value; }
    public int z { readonly get => m_Position.z; set => m_Position.z = value; }
    public Vector3Int position { readonly get => m_Position; set => m_Position = value; }
    public Vector3Int size { readonly get => m_Size; set => m_Size = value; }
    public Vector3 center => new(x + m_Size.x / 2f, y + m_Size.y / 2f, z + m_Size.z / 2f);

    public int xMin { readonly get => Math.Min(m_Position.x, m_Position.x + m_Size.x); set { int end = xMax; m_Position.x = value; m_Size.x = end - value; } }
    public int yMin { readonly get => Math.Min(m_Position.y, m_Position.y + m_Size.y); set { int end = yMax; m_Position.y = value; m_Size.y = end - value; } }
    public int zMin { readonly get => Math.Min(m_Position.z, m_Position.z + m_Size.z); set { int end = zMax; m_Position.z = value; m_Size.z = end - value; } }
    public int xMax { readonly get => Math.Max(m_Position.x, m_Position.x + m_Size.x); set => m_Size.x = value - m_Position.x; }
    public int yMax { readonly get => Math.Max(m_Position.y, m_Position.y + m_Size.y); set => m_Size.y = value - m_Position.y; }
    public int zMax { readonly get => Math.Max(m_Position.z, m_Position.z + m_Size.z); set => m_Size.z = value - m_Position.z; }
    public Vector3Int min { get => new(xMin, yMin, zMin); set { xMin = value.x; yMin = value.y; zMin = value.z; } }
    public Vector3Int max { get => new(xMax, yMax, zMax); set { xMax = value.x; yMax = value.y; zMax = value.z; } }

    public void SetMinMax(Vector3Int minPosition, Vector3Int maxPosition) { m_Position = minPosition; m_Size = maxPosition - minPosition; }

    public bool Contains(Vector3Int position) =>
        position.x >= xMin && position.y >= yMin && position.z >= zMin && position.x < xMax && position.y < yMax && position.z < zMax;

    public void ClampToBounds(BoundsInt bounds)
    {
        position = Vector3Int.Max(Vector3Int.Min(bounds.max, position), bounds.min);
        size = Vector3Int.Min(bounds.max - position, size);
    }

    public PositionEnumerator allPositionsWithin => new(min, max);

    public static bool operator ==(BoundsInt lhs, BoundsInt rhs) => lhs.Equals(rhs);
    public static bool operator !=(BoundsInt lhs, BoundsInt rhs) => !lhs.Equals(rhs);

    public readonly bool Equals(BoundsInt other) => m_Position == other.m_Position && m_Size == other.m_Size;
    public override readonly bool Equals(object? other) => other is BoundsInt b && Equals(b);
    public override readonly int GetHashCode() => m_Position.GetHashCode() ^ (m_Size.GetHashCode() << 2);
    public override readonly string ToString() => ToString(null, null);
    public readonly string ToString(string? format) => ToString(format, null);
    public readonly string ToString(string? format, IFormatProvider? formatProvider) =>
        $"Position: {m_Position.ToString(format, formatProvider)}, Size: {m_Size.ToString(format, formatProvider)}";

    public struct PositionEnumerator : IEnumerator<Vector3Int>
    {
        readonly Vector3Int m_Min;
        readonly Vector3Int m_Max;
        Vector3Int m_Current;

        public PositionEnumerator(Vector3Int min, Vector3Int max)
        {
            m_Min = m_Current = min;
            m_Max = max;
            Reset();
        }

        public PositionEnumerator GetEnumerator() => this;
        public Vector3Int Current => m_Current;
        object IEnumerator.Current => m_Current;
        void IDisposable.Dispose() { }

        public void Reset()
        {
            m_Current = m_Min;
            m_Current.x--;
        }

        public bool MoveNext()
        {
            if (m_Min.x >= m_Max.x || m_Min.y >= m_Max.y || m_Min.z >= m_Max.z || m_Current.z >= m_Max.z) return false;
            if (++m_Current.x < m_Max.x) return true;
            m_Current.x = m_Min.x;
            if (++m_Current.y < m_Max.y) return true;
            m_Current.y = m_Min.y;
            return ++m_Current.z < m_Max.z;
        }
    }
}
