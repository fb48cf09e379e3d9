namespace UnityEngine.Rendering;

public enum LightProbeUsage
{
    Off = 0,
    BlendProbes = 1,
    UseProxyVolume = 2,
    CustomProvided = 4,
}
