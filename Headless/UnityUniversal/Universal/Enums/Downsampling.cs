namespace UnityEngine.Rendering.Universal;

public enum Downsampling
{
    None,
    _2xBilinear,
    _4xBox,
    _4xBilinear,
}
