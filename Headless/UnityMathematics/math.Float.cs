namespace Unity.Mathematics;

public static partial class math
{
    public static float min(float x, float y) => float.IsNaN(y) || x < y ? x : y;
    public static float max(float x, float y) => float.IsNaN(y) || x > y ? x : y;
    public static float clamp(float x, float a, float b) => max(a, min(b, x));
    public static float abs(float x) => MathF.Abs(x);
    public static float floor(float x) => MathF.Floor(x);
    public static float ceil(float x) => MathF.Ceiling(x);
    public static float round(float x) => MathF.Round(x);
    public static float sqrt(float x) => MathF.Sqrt(x);
    public static float rsqrt(float x) => 1 / MathF.Sqrt(x);
    public static float sin(float x) => MathF.Sin(x);
    public static float cos(float x) => MathF.Cos(x);
    public static float exp(float x) => MathF.Exp(x);
    public static float log(float x) => MathF.Log(x);
    public static float pow(float x, float y) => MathF.Pow(x, y);
    public static float lerp(float x, float y, float s) => x + s * (y - x);
    public static float saturate(float x) => clamp(x, 0, 1);
    public static float select(float a, float b, bool c) => c ? b : a;
    public static bool isfinite(float x) => float.IsFinite(x);
    public static bool isnan(float x) => float.IsNaN(x);

    public static float3 abs(float3 x) => new(abs(x.x), abs(x.y), abs(x.z));
    public static float3 floor(float3 x) => new(floor(x.x), floor(x.y), floor(x.z));
    public static float3 ceil(float3 x) => new(ceil(x.x), ceil(x.y), ceil(x.z));
    public static float3 sqrt(float3 x) => new(sqrt(x.x), sqrt(x.y), sqrt(x.z));
    public static float3 min(float3 x, float3 y) => new(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z));
    public static float3 max(float3 x, float3 y) => new(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z));
    public static float3 clamp(float3 x, float3 a, float3 b) => max(a, min(b, x));
    public static float3 lerp(float3 x, float3 y, float s) => x + s * (y - x);
    public static float3 select(float3 a, float3 b, bool3 c) => new(c.x ? b.x : a.x, c.y ? b.y : a.y, c.z ? b.z : a.z);
    public static bool3 isfinite(float3 x) => new(isfinite(x.x), isfinite(x.y), isfinite(x.z));
    public static float dot(float3 x, float3 y) => x.x * y.x + x.y * y.y + x.z * y.z;
    public static float3 cross(float3 x, float3 y) => new(x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z, x.x * y.y - x.y * y.x);
    public static float lengthsq(float3 x) => dot(x, x);
    public static float length(float3 x) => sqrt(dot(x, x));
    public static float distance(float3 x, float3 y) => length(y - x);
    public static float distancesq(float3 x, float3 y) => lengthsq(y - x);
    public static float3 normalize(float3 x) => rsqrt(dot(x, x)) * x;
    public static float csum(float3 x) => x.x + x.y + x.z;
    public static float cmin(float3 x) => min(min(x.x, x.y), x.z);
    public static float cmax(float3 x) => max(max(x.x, x.y), x.z);
    public static float3 float3(float x, float y, float z) => new(x, y, z);
}
