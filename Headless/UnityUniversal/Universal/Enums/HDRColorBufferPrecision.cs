namespace UnityEngine.Rendering.Universal;

public enum HDRColorBufferPrecision
{
    _32Bits,
    _64Bits,
}
