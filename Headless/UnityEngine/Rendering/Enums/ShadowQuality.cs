namespace UnityEngine;

public enum ShadowQuality
{
    Disable = 0,
    HardOnly = 1,
    All = 2,
}
