namespace UnityEngine;

public enum LightRenderMode
{
    Auto = 0,
    ForcePixel = 1,
    ForceVertex = 2,
}
