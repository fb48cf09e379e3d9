namespace UnityEngine.Rendering.Universal;

public enum LightRenderingMode
{
    Disabled = 0,
    PerPixel = 1,
    PerVertex = 2,
}
