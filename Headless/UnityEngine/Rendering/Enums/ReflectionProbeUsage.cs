namespace UnityEngine.Rendering;

public enum ReflectionProbeUsage
{
    Off = 0,
    BlendProbes = 1,
    BlendProbesAndSkybox = 2,
    Simple = 3,
}
