namespace UnityEngine.Rendering;

public enum ReflectionProbeRefreshMode
{
    OnAwake = 0,
    EveryFrame = 1,
    ViaScripting = 2,
}
