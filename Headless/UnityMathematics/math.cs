namespace Unity.Mathematics;

/// <summary>HLSL's functions by their HLSL names.</summary>
public static partial class math
{
    public const float PI = 3.14159265f;
    public const double PI_DBL = 3.14159265358979323846;

    public static int min(int x, int y) => x < y ? x : y;
    public static int max(int x, int y) => x > y ? x : y;
    public static int clamp(int x, int a, int b) => max(a, min(b, x));
    public static int abs(int x) => max(-x, x);
    public static int select(int a, int b, bool c) => c ? b : a;

    public static int3 int3(int x, int y, int z) => new(x, y, z);
    public static int3 min(int3 x, int3 y) => new(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z));
    public static int3 max(int3 x, int3 y) => new(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z));
    public static int3 clamp(int3 x, int3 a, int3 b) => max(a, min(b, x));
    public static int3 select(int3 a, int3 b, bool3 c) => new(c.x ? b.x : a.x, c.y ? b.y : a.y, c.z ? b.z : a.z);
    public static int csum(int3 x) => x.x + x.y + x.z;

    public static bool all(bool3 x) => x.x && x.y && x.z;
    public static bool any(bool3 x) => x.x || x.y || x.z;
}
