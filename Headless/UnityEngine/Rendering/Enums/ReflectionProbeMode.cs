namespace UnityEngine.Rendering;

public enum ReflectionProbeMode
{
    Baked = 0,
    Realtime = 1,
    Custom = 2,
}
