namespace UnityEngine;

public enum ShadowProjection
{
    CloseFit = 0,
    StableFit = 1,
}
