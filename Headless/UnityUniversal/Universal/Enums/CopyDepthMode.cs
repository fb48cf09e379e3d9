namespace UnityEngine.Rendering.Universal;

public enum CopyDepthMode
{
    AfterOpaques,
    AfterTransparents,
    ForcePrepass,
}
