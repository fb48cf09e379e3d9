namespace UnityEngine.Rendering;

public enum ShadowCastingMode
{
    Off = 0,
    On = 1,
    TwoSided = 2,
    ShadowsOnly = 3,
}
