namespace UnityEngine;

public enum TransparencySortMode
{
    Default = 0,
    Perspective = 1,
    Orthographic = 2,
    CustomAxis = 3,
}
