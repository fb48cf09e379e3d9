namespace UnityEngine.Rendering.Universal;

public enum AntialiasingQuality
{
    Low,
    Medium,
    High,
}
