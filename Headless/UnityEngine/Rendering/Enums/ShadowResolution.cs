namespace UnityEngine;

public enum ShadowResolution
{
    Low = 0,
    Medium = 1,
    High = 2,
    VeryHigh = 3,
}
