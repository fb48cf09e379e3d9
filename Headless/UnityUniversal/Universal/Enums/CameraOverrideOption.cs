namespace UnityEngine.Rendering.Universal;

public enum CameraOverrideOption
{
    Off,
    On,
    UsePipelineSettings,
}
