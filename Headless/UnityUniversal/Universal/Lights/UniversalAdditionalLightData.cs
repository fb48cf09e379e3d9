namespace UnityEngine.Rendering.Universal;

/// <summary>The pipeline's own settings of a light; the names of the fields are those of Unity's scenes.</summary>
[DisallowMultipleComponent]
[RequireComponent(typeof(Light))]
public class UniversalAdditionalLightData : MonoBehaviour
{
    [SerializeField] private bool m_UsePipelineSettings = true;
    [SerializeField] private int m_AdditionalLightsShadowResolutionTier = 2;
    [SerializeField] private SoftShadowQuality m_SoftShadowQuality = SoftShadowQuality.UsePipelineSettings;

    /// <summary>Whether the shadow's bias is the asset's and not the light's.</summary>
    public bool usePipelineSettings { get => m_UsePipelineSettings; set => m_UsePipelineSettings = value; }
    public int additionalLightsShadowResolutionTier => m_AdditionalLightsShadowResolutionTier;
    public SoftShadowQuality softShadowQuality { get => m_SoftShadowQuality; set => m_SoftShadowQuality = value; }
}
