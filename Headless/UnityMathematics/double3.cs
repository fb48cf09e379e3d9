using System.Globalization;

namespace Unity.Mathematics;

public struct double3 : IEquatable<double3>, IFormattable
{
    public double x;
    public double y;
    public double z;

    public static readonly double3 zero;

    public double3(double x, double y, double z) { this.x = x; this.y = y; this.z = z; }
    public double3(double v) : this(v, v, v) { }
    public double3(float3 v) : this(v.x, v.y, v.z) { }
    public double3(int3 v) : this(v.x, v.y, v.z) { }

    public double this[int index]
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

    public static implicit operator double3(double v) => new(v);
    public static implicit operator double3(float3 v) => new(v);
    public static implicit operator double3(int3 v) => new(v);

    public static double3 operator +(double3 lhs, double3 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z);
    public static double3 operator +(double3 lhs, double rhs) => new(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs);
    public static double3 operator +(double lhs, double3 rhs) => new(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z);
    public static double3 operator -(double3 lhs, double3 rhs) => new(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z);
    public static double3 operator -(double3 lhs, double rhs) => new(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs);
    public static double3 operator -(double lhs, double3 rhs) => new(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z);
    public static double3 operator *(double3 lhs, double3 rhs) => new(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z);
    public static double3 operator *(double3 lhs, double rhs) => new(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs);
    public static double3 operator *(double lhs, double3 rhs) => new(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z);
    public static double3 operator /(double3 lhs, double3 rhs) => new(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z);
    public static double3 operator /(double3 lhs, double rhs) => new(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs);
    public static double3 operator /(double lhs, double3 rhs) => new(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z);
    public static double3 operator -(double3 val) => new(-val.x, -val.y, -val.z);
    public static double3 operator +(double3 val) => val;

    public static bool3 operator <(double3 lhs, double3 rhs) => new(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z);
    public static bool3 operator <(double3 lhs, double rhs) => lhs < new double3(rhs);
    public static bool3 operator <(double lhs, double3 rhs) => new double3(lhs) < rhs;
    public static bool3 operator <=(double3 lhs, double3 rhs) => new(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z);
    public static bool3 operator <=(double3 lhs, double rhs) => lhs <= new double3(rhs);
    public static bool3 operator <=(double lhs, double3 rhs) => new double3(lhs) <= rhs;
    public static bool3 operator >(double3 lhs, double3 rhs) => new(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z);
    public static bool3 operator >(double3 lhs, double rhs) => lhs > new double3(rhs);
    public static bool3 operator >(double lhs, double3 rhs) => new double3(lhs) > rhs;
    public static bool3 operator >=(double3 lhs, double3 rhs) => new(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z);
    public static bool3 operator >=(double3 lhs, double rhs) => lhs >= new double3(rhs);
    public static bool3 operator >=(double lhs, double3 rhs) => new double3(lhs) >= rhs;
    public static bool3 operator ==(double3 lhs, double3 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);
    public static bool3 operator ==(double3 lhs, double rhs) => lhs == new double3(rhs);
    public static bool3 operator ==(double lhs, double3 rhs) => new double3(lhs) == rhs;
    public static bool3 operator !=(double3 lhs, double3 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);
    public static bool3 operator !=(double3 lhs, double rhs) => lhs != new double3(rhs);
    public static bool3 operator !=(double lhs, double3 rhs) => new double3(lhs) != rhs;

    public readonly bool Equals(double3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;
    public override readonly bool Equals(object? o) => o is double3 other && Equals(other);
    public override readonly int GetHashCode() => HashCode.Combine(x, y, z);
    public override readonly string ToString() => ToString(null, CultureInfo.CurrentCulture);
    public readonly string ToString(string? format, IFormatProvider? formatProvider) =>
        $"double3({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)}, {z.ToString(format, formatProvider)})";
}
