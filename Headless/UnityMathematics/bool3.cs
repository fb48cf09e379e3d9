namespace Unity.Mathematics;

public struct bool3 : IEquatable<bool3>
{
    public bool x;
    public bool y;
    public bool z;

    public bool3(bool x, bool y, bool z) { this.x = x; this.y = y; this.z = z; }
    public bool3(bool v) : this(v, v, v) { }

    public static implicit operator bool3(bool v) => new(v);
    public static bool3 operator &(bool3 lhs, bool3 rhs) => new(lhs.x & rhs.x, lhs.y & rhs.y, lhs.z & rhs.z);
    public static bool3 operator |(bool3 lhs, bool3 rhs) => new(lhs.x | rhs.x, lhs.y | rhs.y, lhs.z | rhs.z);
    public static bool3 operator !(bool3 val) => new(!val.x, !val.y, !val.z);
    public static bool3 operator ==(bool3 lhs, bool3 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);
    public static bool3 operator !=(bool3 lhs, bool3 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);

    public readonly bool Equals(bool3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;
    public override readonly bool Equals(object? o) => o is bool3 other && Equals(other);
    public override readonly int GetHashCode() => HashCode.Combine(x, y, z);
    public override readonly string ToString() => $"bool3({x}, {y}, {z})";
}
