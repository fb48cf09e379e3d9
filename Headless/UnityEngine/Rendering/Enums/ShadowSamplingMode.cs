namespace UnityEngine.Rendering;

public enum ShadowSamplingMode
{
    CompareDepths = 0,
    RawDepth = 1,
    None = 2,
}
