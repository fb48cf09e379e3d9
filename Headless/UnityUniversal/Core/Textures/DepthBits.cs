namespace UnityEngine.Rendering;

public enum DepthBits
{
    None = 0,
    Depth8 = 8,
    Depth16 = 16,
    Depth24 = 24,
    Depth32 = 32,
}
