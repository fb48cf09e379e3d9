using Headless.Engine;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Light : Behaviour
{
    public LightType type { get; set; } = LightType.Point;
    public Color color { get; set; } = Color.white;
    public float intensity { get; set; } = 1f;
    public float bounceIntensity { get; set; } = 1f;
    public float range { get; set; } = 10f;
    public float spotAngle { get; set; } = 30f;
    public float innerSpotAngle { get; set; } = 21.8f;
    public int cullingMask { get; set; } = -1;
    public LightRenderMode renderMode { get; set; }
    public LightShadows shadows { get; set; }
    public float shadowStrength { get; set; } = 1f;
    public float shadowBias { get; set; } = 0.05f;
    public float shadowNormalBias { get; set; } = 0.4f;
    public float shadowNearPlane { get; set; } = 0.2f;
    public LightShadowResolution shadowResolution { get; set; } = LightShadowResolution.FromQualitySettings;
    public int shadowCustomResolution { get; set; } = -1;
    public LightmapBakeType lightmapBakeType { get; set; } = LightmapBakeType.Realtime;
    public float colorTemperature { get; set; } = 6570f;
    public bool useColorTemperature { get; set; }
    public int renderingLayerMask { get; set; } = 1;
    public Texture? cookie { get; set; }
    public float cookieSize { get; set; } = 10f;

    /// <summary>As shaders see it. Without linear intensity the color is multiplied before it becomes linear, as Built-in does.</summary>
    internal Color FinalColor => GraphicsSettings.lightsUseLinearIntensity ? color.linear * intensity * Temperature : (color * intensity).linear;

    private Color Temperature => GraphicsSettings.lightsUseColorTemperature && useColorTemperature
        ? Mathf.CorrelatedColorTemperatureToRGB(colorTemperature)
        : Color.white;

    internal override void OnAdded() => LightList.Add(this);

    internal override void OnRemoved() => LightList.Remove(this);
}
