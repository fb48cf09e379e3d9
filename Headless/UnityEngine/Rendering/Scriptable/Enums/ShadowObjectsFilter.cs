namespace UnityEngine;

public enum ShadowObjectsFilter
{
    AllObjects = 0,
    DynamicOnly = 1,
    StaticOnly = 2,
}
