namespace UnityEngine;

public enum RigidbodyInterpolation
{
    None = 0,
    Interpolate = 1,
    Extrapolate = 2,
}
