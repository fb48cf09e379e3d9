using System.Globalization;

namespace Unity.Mathematics;

public struct int3 : IEquatable<int3>, IFormattable
{
    public int x;
    public int y;
    public int z;

    public static readonly int3 zero;

    public int3(int x, int y, int z) { this.x = x; this.y = y; this.z = z; }
    public int3(int v) : this(v, v, v) { }
    public int3(double3 v) : this((int)v.x, (int)v.y, (int)v.z) { }
    public int3(float3 v) : this((int)v.x, (int)v.y, (int)v.z) { }

    public int this[int index]
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

    public static implicit operator int3(int v) => new(v);
    public static explicit operator int3(double3 v) => new(v);
    public static explicit operator int3(float3 v) => new(v);

    public static int3 operator +(int3 lhs, int3 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z);
    public static int3 operator +(int3 lhs, int rhs) => new(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs);
    public static int3 operator +(int lhs, int3 rhs) => new(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z);
    public static int3 operator -(int3 lhs, int3 rhs) => new(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z);
    public static int3 operator -(int3 lhs, int rhs) => new(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs);
    public static int3 operator -(int lhs, int3 rhs) => new(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z);
    public static int3 operator *(int3 lhs, int3 rhs) => new(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z);
    public static int3 operator *(int3 lhs, int rhs) => new(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs);
    public static int3 operator *(int lhs, int3 rhs) => new(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z);
    public static int3 operator /(int3 lhs, int3 rhs) => new(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z);
    public static int3 operator /(int3 lhs, int rhs) => new(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs);
    public static int3 operator /(int lhs, int3 rhs) => new(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z);
    public static int3 operator -(int3 val) => new(-val.x, -val.y, -val.z);
    public static int3 operator +(int3 val) => val;

    public static bool3 operator <(int3 lhs, int3 rhs) => new(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z);
    public static bool3 operator <(int3 lhs, int rhs) => lhs < new int3(rhs);
    public static bool3 operator <(int lhs, int3 rhs) => new int3(lhs) < rhs;
    public static bool3 operator <=(int3 lhs, int3 rhs) => new(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z);
    public static bool3 operator <=(int3 lhs, int rhs) => lhs <= new int3(rhs);
    public static bool3 operator <=(int lhs, int3 rhs) => new int3(lhs) <= rhs;
    public static bool3 operator >(int3 lhs, int3 rhs) => new(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z);
    public static bool3 operator >(int3 lhs, int rhs) => lhs > new int3(rhs);
    public static bool3 operator >(int lhs, int3 rhs) => new int3(lhs) > rhs;
    public static bool3 operator >=(int3 lhs, int3 rhs) => new(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z);
    public static bool3 operator >=(int3 lhs, int rhs) => lhs >= new int3(rhs);
    public static bool3 operator >=(int lhs, int3 rhs) => new int3(lhs) >= rhs;
    public static bool3 operator ==(int3 lhs, int3 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);
    public static bool3 operator ==(int3 lhs, int rhs) => lhs == new int3(rhs);
    public static bool3 operator ==(int lhs, int3 rhs) => new int3(lhs) == rhs;
    public static bool3 operator !=(int3 lhs, int3 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);
    public static bool3 operator !=(int3 lhs, int rhs) => lhs != new int3(rhs);
    public static bool3 operator !=(int lhs, int3 rhs) => new int3(lhs) != rhs;

    public readonly bool Equals(int3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;
    public override readonly bool Equals(object? o) => o is int3 other && Equals(other);
    public override readonly int GetHashCode() => HashCode.Combine(x, y, z);
    public override readonly string ToString() => ToString(null, CultureInfo.CurrentCulture);
    public readonly string ToString(string? format, IFormatProvider? formatProvider) =>
        $"int3({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)}, {z.ToString(format, formatProvider)})";
}
