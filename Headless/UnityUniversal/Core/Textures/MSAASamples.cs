namespace UnityEngine.Rendering;

public enum MSAASamples
{
    None = 1,
    MSAA2x = 2,
    MSAA4x = 4,
    MSAA8x = 8,
}
