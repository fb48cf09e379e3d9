namespace UnityEngine.Rendering.Universal;

public enum DepthPrimingMode
{
    Disabled,
    Auto,
    Forced,
}
