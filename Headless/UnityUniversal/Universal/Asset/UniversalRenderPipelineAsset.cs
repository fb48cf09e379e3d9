using System;
using System.Linq;

namespace UnityEngine.Rendering.Universal;

/// <summary>Settings of the pipeline; the names of the fields are those of Unity's asset files.</summary>
public class UniversalRenderPipelineAsset : RenderPipelineAsset
{
    [SerializeField] internal ScriptableRendererData?[] m_RendererDataList = new ScriptableRendererData?[1];
    [SerializeField] internal int m_DefaultRendererIndex;
    [SerializeField] private bool m_RequireDepthTexture;
    [SerializeField] private bool m_RequireOpaqueTexture;
    [SerializeField] private Downsampling m_OpaqueDownsampling = Downsampling._2xBilinear;
    [SerializeField] private bool m_SupportsHDR = true;
    [SerializeField] private HDRColorBufferPrecision m_HDRColorBufferPrecision = HDRColorBufferPrecision._32Bits;
    [SerializeField] private MsaaQuality m_MSAA = MsaaQuality.Disabled;
    [SerializeField] private float m_RenderScale = 1f;
    [SerializeField] private LightRenderingMode m_MainLightRenderingMode = LightRenderingMode.PerPixel;
    [SerializeField] private bool m_MainLightShadowsSupported = true;
    [SerializeField] private ShadowResolution m_MainLightShadowmapResolution = ShadowResolution._2048;
    [SerializeField] private LightRenderingMode m_AdditionalLightsRenderingMode = LightRenderingMode.PerPixel;
    [SerializeField] private int m_AdditionalLightsPerObjectLimit = 4;
    [SerializeField] private bool m_AdditionalLightShadowsSupported;
    [SerializeField] private ShadowResolution m_AdditionalLightsShadowmapResolution = ShadowResolution._2048;
    [SerializeField] private bool m_ReflectionProbeBlending;
    [SerializeField] private bool m_ReflectionProbeBoxProjection;
    [SerializeField] private float m_ShadowDistance = 50f;
    [SerializeField] private int m_ShadowCascadeCount = 1;
    [SerializeField] private float m_Cascade2Split = 0.25f;
    [SerializeField] private Vector2 m_Cascade3Split = new(0.1f, 0.3f);
    [SerializeField] private Vector3 m_Cascade4Split = new(0.067f, 0.2f, 0.467f);
    [SerializeField] private float m_CascadeBorder = 0.2f;
    [SerializeField] private float m_ShadowDepthBias = 1f;
    [SerializeField] private float m_ShadowNormalBias = 1f;
    [SerializeField] private bool m_SoftShadowsSupported;
    [SerializeField] private SoftShadowQuality m_SoftShadowQuality = SoftShadowQuality.Medium;
    [SerializeField] private bool m_UseSRPBatcher = true;
    [SerializeField] private bool m_SupportsDynamicBatching;
    [SerializeField] private bool m_MixedLightingSupported = true;
    [SerializeField] private bool m_SupportsLightLayers;

    private ScriptableRenderer?[] made = [];
    private Material? lit;

    public bool supportsCameraDepthTexture { get => m_RequireDepthTexture; set => m_RequireDepthTexture = value; }
    public bool supportsCameraOpaqueTexture { get => m_RequireOpaqueTexture; set => m_RequireOpaqueTexture = value; }
    public Downsampling opaqueDownsampling => m_OpaqueDownsampling;
    public bool supportsHDR { get => m_SupportsHDR; set => m_SupportsHDR = value; }
    public HDRColorBufferPrecision hdrColorBufferPrecision { get => m_HDRColorBufferPrecision; set => m_HDRColorBufferPrecision = value; }
    public int msaaSampleCount { get => (int)m_MSAA; set => m_MSAA = (MsaaQuality)value; }
    public float renderScale { get => m_RenderScale; set => m_RenderScale = Mathf.Clamp(value, UniversalRenderPipeline.minRenderScale, UniversalRenderPipeline.maxRenderScale); }
    public LightRenderingMode mainLightRenderingMode => m_MainLightRenderingMode;
    public bool supportsMainLightShadows => m_MainLightShadowsSupported;
    public int mainLightShadowmapResolution { get => (int)m_MainLightShadowmapResolution; set => m_MainLightShadowmapResolution = (ShadowResolution)value; }
    public LightRenderingMode additionalLightsRenderingMode => m_AdditionalLightsRenderingMode;

    public int maxAdditionalLightsCount
    {
        get => m_AdditionalLightsPerObjectLimit;
        set => m_AdditionalLightsPerObjectLimit = Mathf.Clamp(value, 0, UniversalRenderPipeline.maxPerObjectLights);
    }

    public bool supportsAdditionalLightShadows => m_AdditionalLightShadowsSupported;
    public int additionalLightsShadowmapResolution { get => (int)m_AdditionalLightsShadowmapResolution; set => m_AdditionalLightsShadowmapResolution = (ShadowResolution)value; }
    public bool reflectionProbeBlending => m_ReflectionProbeBlending;
    public bool reflectionProbeBoxProjection => m_ReflectionProbeBoxProjection;
    public float shadowDistance { get => m_ShadowDistance; set => m_ShadowDistance = Mathf.Max(0f, value); }

    public int shadowCascadeCount
    {
        get => m_ShadowCascadeCount;
        set => m_ShadowCascadeCount = value is >= 1 and <= 4 ? value : throw new ArgumentException($"Value ({value}) needs to be between 1 and 4.");
    }

    public float cascade2Split { get => m_Cascade2Split; set => m_Cascade2Split = value; }
    public Vector2 cascade3Split { get => m_Cascade3Split; set => m_Cascade3Split = value; }
    public Vector3 cascade4Split { get => m_Cascade4Split; set => m_Cascade4Split = value; }
    public float cascadeBorder { get => m_CascadeBorder; set => m_CascadeBorder = value; }
    public float shadowDepthBias { get => m_ShadowDepthBias; set => m_ShadowDepthBias = value; }
    public float shadowNormalBias { get => m_ShadowNormalBias; set => m_ShadowNormalBias = value; }
    public bool supportsSoftShadows => m_SoftShadowsSupported;
    public bool useSRPBatcher { get => m_UseSRPBatcher; set => m_UseSRPBatcher = value; }
    public bool supportsDynamicBatching { get => m_SupportsDynamicBatching; set => m_SupportsDynamicBatching = value; }
    public bool supportsMixedLighting => m_MixedLightingSupported;
    public bool useRenderingLayers => m_SupportsLightLayers;

    public ScriptableRenderer scriptableRenderer => GetRenderer(-1);
    public ReadOnlySpan<ScriptableRendererData?> rendererDataList => m_RendererDataList;
    public override Shader defaultShader => UniversalShaders.Find("Universal Render Pipeline/Lit");

    /// <summary>Of primitives, and of renderers without a material of their own.</summary>
    public override Material defaultMaterial
    {
        get
        {
            if (lit == null)
            {
                lit = new Material(defaultShader) { name = "Lit", hideFlags = HideFlags.NotEditable };
            }

            return lit;
        }
    }

    internal SoftShadowQuality SoftShadowQuality => m_SoftShadowQuality;

    /// <summary>The asset of the menu Rendering, URP Asset.</summary>
    /// <param name="rendererData">Null: a renderer as the menu makes it.</param>
    public static UniversalRenderPipelineAsset Create(ScriptableRendererData? rendererData = null)
    {
        var asset = CreateInstance<UniversalRenderPipelineAsset>();
        asset.m_RendererDataList[0] = rendererData != null ? rendererData : CreateInstance<UniversalRendererData>();
        return asset;
    }

    /// <param name="index">Of rendererDataList; -1 or one that is not there: the default renderer.</param>
    public ScriptableRenderer GetRenderer(int index)
    {
        if (index < 0 || index >= m_RendererDataList.Length || m_RendererDataList[index] == null)
        {
            index = m_DefaultRendererIndex;
        }

        if (made.Length != m_RendererDataList.Length)
        {
            Forget();
            made = new ScriptableRenderer?[m_RendererDataList.Length];
        }

        ScriptableRendererData data = index >= 0 && index < m_RendererDataList.Length && m_RendererDataList[index] is { } there && there != null
            ? there
            : throw new InvalidOperationException($"URP asset '{name}': Default Renderer is missing; there must be a default renderer assigned for the current pipeline to work.");
        if (made[index] is null || data.IsInvalidated)
        {
            made[index]?.Dispose();
            made[index] = data.InternalCreate();
        }

        return made[index]!;
    }

    protected override RenderPipeline CreatePipeline()
    {
        Forget();
        return new UniversalRenderPipeline(this);
    }

    protected override void OnValidate() => base.OnValidate();

    protected override void OnDisable()
    {
        Forget();
        base.OnDisable();
    }

    internal Vector3 CascadeSplit() => m_ShadowCascadeCount switch
    {
        1 => new Vector3(1f, 0f, 0f),
        2 => new Vector3(m_Cascade2Split, 1f, 0f),
        3 => new Vector3(m_Cascade3Split.x, m_Cascade3Split.y, 0f),
        _ => m_Cascade4Split,
    };

    internal void Forget()
    {
        foreach (ScriptableRenderer renderer in made.OfType<ScriptableRenderer>())
        {
            renderer.Dispose();
        }

        made = [];
    }
}
