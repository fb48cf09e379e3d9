namespace Unity.Mathematics;

public static partial class math
{
    public static double min(double x, double y) => double.IsNaN(y) || x < y ? x : y;
    public static double max(double x, double y) => double.IsNaN(y) || x > y ? x : y;
    public static double clamp(double x, double a, double b) => max(a, min(b, x));
    public static double abs(double x) => Math.Abs(x);
    public static double floor(double x) => Math.Floor(x);
    public static double ceil(double x) => Math.Ceiling(x);
    public static double round(double x) => Math.Round(x);
    public static double sqrt(double x) => Math.Sqrt(x);
    public static double rsqrt(double x) => 1 / Math.Sqrt(x);
    public static double sin(double x) => Math.Sin(x);
    public static double cos(double x) => Math.Cos(x);
    public static double exp(double x) => Math.Exp(x);
    public static double log(double x) => Math.Log(x);
    public static double pow(double x, double y) => Math.Pow(x, y);
    public static double lerp(double x, double y, double s) => x + s * (y - x);
    public static double saturate(double x) => clamp(x, 0, 1);
    public static double select(double a, double b, bool c) => c ? b : a;
    public static bool isfinite(double x) => double.IsFinite(x);
    public static bool isnan(double x) => double.IsNaN(x);

    public static double3 abs(double3 x) => new(abs(x.x), abs(x.y), abs(x.z));
    public static double3 floor(double3 x) => new(floor(x.x), floor(x.y), floor(x.z));
    public static double3 ceil(double3 x) => new(ceil(x.x), ceil(x.y), ceil(x.z));
    public static double3 sqrt(double3 x) => new(sqrt(x.x), sqrt(x.y), sqrt(x.z));
    public static double3 min(double3 x, double3 y) => new(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z));
    public static double3 max(double3 x, double3 y) => new(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z));
    public static double3 clamp(double3 x, double3 a, double3 b) => max(a, min(b, x));
    public static double3 lerp(double3 x, double3 y, double s) => x + s * (y - x);
    public static double3 select(double3 a, double3 b, bool3 c) => new(c.x ? b.x : a.x, c.y ? b.y : a.y, c.z ? b.z : a.z);
    public static bool3 isfinite(double3 x) => new(isfinite(x.x), isfinite(x.y), isfinite(x.z));
    public static double dot(double3 x, double3 y) => x.x * y.x + x.y * y.y + x.z * y.z;
    public static double3 cross(double3 x, double3 y) => new(x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z, x.x * y.y - x.y * y.x);
    public static double lengthsq(double3 x) => dot(x, x);
    public static double length(double3 x) => sqrt(dot(x, x));
    public static double distance(double3 x, double3 y) => length(y - x);
    public static double distancesq(double3 x, double3 y) => lengthsq(y - x);
    public static double3 normalize(double3 x) => rsqrt(dot(x, x)) * x;
    public static double csum(double3 x) => x.x + x.y + x.z;
    public static double cmin(double3 x) => min(min(x.x, x.y), x.z);
    public static double cmax(double3 x) => max(max(x.x, x.y), x.z);
    public static double3 double3(double x, double y, double z) => new(x, y, z);
}
