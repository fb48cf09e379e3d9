namespace UnityEngine.Rendering.Universal;

public enum AntialiasingMode
{
    None = 0,
    FastApproximateAntialiasing = 1,
    SubpixelMorphologicalAntiAliasing = 2,
    TemporalAntiAliasing = 3,
}
