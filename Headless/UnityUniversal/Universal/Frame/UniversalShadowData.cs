using System.Collections.Generic;

namespace UnityEngine.Rendering.Universal;

/// <summary>The shadows of a camera.</summary>
public class UniversalShadowData : ContextItem
{
    public bool supportsMainLightShadows;
    public bool supportsAdditionalLightShadows;
    public bool supportsSoftShadows;
    public int mainLightShadowmapWidth;
    public int mainLightShadowmapHeight;
    public int mainLightShadowCascadesCount;
    public Vector3 mainLightShadowCascadesSplit;
    public float mainLightShadowCascadeBorder;
    public int additionalLightsShadowmapWidth;
    public int additionalLightsShadowmapHeight;
    public int shadowmapDepthBufferBits;
    public List<Vector4> bias = [];
    public List<int> resolution = [];

    /// <summary>Whether the asset has shadows of the main light, seen or not: their keyword stays on then.</summary>
    internal bool MainLightShadowsEnabled { get; set; }

    public override void Reset() => bias.Clear();
}
