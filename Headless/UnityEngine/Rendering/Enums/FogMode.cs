namespace UnityEngine;

public enum FogMode
{
    Linear = 1,
    Exponential = 2,
    ExponentialSquared = 3,
}
