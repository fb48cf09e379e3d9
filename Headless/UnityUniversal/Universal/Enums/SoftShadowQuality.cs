namespace UnityEngine.Rendering.Universal;

public enum SoftShadowQuality
{
    UsePipelineSettings = 0,
    Low = 1,
    Medium = 2,
    High = 3,
}
