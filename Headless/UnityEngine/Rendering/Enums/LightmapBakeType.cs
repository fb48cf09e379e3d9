namespace UnityEngine;

public enum LightmapBakeType
{
    Mixed = 1,
    Baked = 2,
    Realtime = 4,
}
