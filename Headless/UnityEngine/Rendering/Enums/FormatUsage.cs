namespace UnityEngine.Experimental.Rendering;

public enum FormatUsage
{
    Sample = 0,
    Linear = 1,
    Sparse = 2,
    Render = 4,
    Blend = 5,
    GetPixels = 6,
    SetPixels = 7,
    SetPixels32 = 8,
    ReadPixels = 9,
    LoadStore = 10,
    MSAA2x = 11,
    MSAA4x = 12,
    MSAA8x = 13,
    StencilSampling = 16,
}
