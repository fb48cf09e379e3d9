namespace UnityEngine;

public enum QueryTriggerInteraction
{
    UseGlobal = 0,
    Ignore = 1,
    Collide = 2,
}
