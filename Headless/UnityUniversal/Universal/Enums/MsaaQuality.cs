namespace UnityEngine.Rendering.Universal;

public enum MsaaQuality
{
    Disabled = 1,
    _2x = 2,
    _4x = 4,
    _8x = 8,
}
