using System.Globalization;

namespace Unity.Mathematics;

public struct float3 : IEquatable<float3>, IFormattable
{
    public float x;
    public float y;
    public float z;

    public static readonly float3 zero;

    public float3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }
    public float3(float v) : this(v, v, v) { }
    public float3(double3 v) : this((float)v.x, (float)v.y, (float)v.z) { }
    public float3(int3 v) : this(v.x, v.y, v.z) { }

    public float this[int index]
    {
        readonly get => index switch { 0 => x, 1 => y, 2 => z, _ => throw new ArgumentException("index must be between[0...2]") };
        set
        {
            switch (index)
            {
                case 0: x = value; break;
                case 1: y = value; break;
                case 2: z = value; break;
                default: throw new ArgumentException("index must be between[0...2]");
            }
        }
    }

    public static implicit operator float3(float v) => new(v);
    public static explicit operator float3(double3 v) => new(v);
    public static implicit operator float3(int3 v) => new(v);
    public static implicit operator float3(UnityEngine.Vector3 v) => new(v.x, v.y, v.z);
    public static implicit operator UnityEngine.Vector3(float3 v) => new(v.x, v.y, v.z);

    public static float3 operator +(float3 lhs, float3 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z);
    public static float3 operator +(float3 lhs, float rhs) => new(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs);
    public static float3 operator +(float lhs, float3 rhs) => new(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z);
    public static float3 operator -(float3 lhs, float3 rhs) => new(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z);
    public static float3 operator -(float3 lhs, float rhs) => new(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs);
    public static float3 operator -(float lhs, float3 rhs) => new(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z);
    public static float3 operator *(float3 lhs, float3 rhs) => new(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z);
    public static float3 operator *(float3 lhs, float rhs) => new(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs);
    public static float3 operator *(float lhs, float3 rhs) => new(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z);
    public static float3 operator /(float3 lhs, float3 rhs) => new(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z);
    public static float3 operator /(float3 lhs, float rhs) => new(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs);
    public static float3 operator /(float lhs, float3 rhs) => new(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z);
    public static float3 operator -(float3 val) => new(-val.x, -val.y, -val.z);
    public static float3 operator +(float3 val) => val;

    public static bool3 operator <(float3 lhs, float3 rhs) => new(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z);
    public static bool3 operator <(float3 lhs, float rhs) => lhs < new float3(rhs);
    public static bool3 operator <(float lhs, float3 rhs) => new float3(lhs) < rhs;
    public static bool3 operator <=(float3 lhs, float3 rhs) => new(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z);
    public static bool3 operator <=(float3 lhs, float rhs) => lhs <= new float3(rhs);
    public static bool3 operator <=(float lhs, float3 rhs) => new float3(lhs) <= rhs;
    public static bool3 operator >(float3 lhs, float3 rhs) => new(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z);
    public static bool3 operator >(float3 lhs, float rhs) => lhs > new float3(rhs);
    public static bool3 operator >(float lhs, float3 rhs) => new float3(lhs) > rhs;
    public static bool3 operator >=(float3 lhs, float3 rhs) => new(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z);
    public static bool3 operator >=(float3 lhs, float rhs) => lhs >= new float3(rhs);
    public static bool3 operator >=(float lhs, float3 rhs) => new float3(lhs) >= rhs;
    public static bool3 operator ==(float3 lhs, float3 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);
    public static bool3 operator ==(float3 lhs, float rhs) => lhs == new float3(rhs);
    public static bool3 operator ==(float lhs, float3 rhs) => new float3(lhs) == rhs;
    public static bool3 operator !=(float3 lhs, float3 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);
    public static bool3 operator !=(float3 lhs, float rhs) => lhs != new float3(rhs);
    public static bool3 operator !=(float lhs, float3 rhs) => new float3(lhs) != rhs;

    public readonly bool Equals(float3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;
    public override readonly bool Equals(object? o) => o is float3 other && Equals(other);
    public override readonly int GetHashCode() => HashCode.Combine(x, y, z);
    public override readonly string ToString() => ToString(null, CultureInfo.CurrentCulture);
    public readonly string ToString(string? format, IFormatProvider? formatProvider) =>
        $"float3({x.ToString(format, formatProvider)}f, {y.ToString(format, formatProvider)}f, {z.ToString(format, formatProvider)}f)";
}
