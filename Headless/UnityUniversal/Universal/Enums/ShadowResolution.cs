namespace UnityEngine.Rendering.Universal;

public enum ShadowResolution
{
    _256 = 256,
    _512 = 512,
    _1024 = 1024,
    _2048 = 2048,
    _4096 = 4096,
    _8192 = 8192,
}
