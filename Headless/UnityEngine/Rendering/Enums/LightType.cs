namespace UnityEngine;

public enum LightType
{
    Spot = 0,
    Directional = 1,
    Point = 2,
    Rectangle = 3,
    Disc = 4,
}
