namespace UnityEngine.Rendering;

public enum LightShadowResolution
{
    FromQualitySettings = -1,
    Low = 0,
    Medium = 1,
    High = 2,
    VeryHigh = 3,
}
