namespace UnityEngine;

public enum FilterMode
{
    Point = 0,
    Bilinear = 1,
    Trilinear = 2,
}
