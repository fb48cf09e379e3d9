namespace UnityEngine.Rendering.Universal;

/// <summary>The settings of UniversalRenderer; the names of the fields are those of Unity's asset files.</summary>
public class UniversalRendererData : ScriptableRendererData
{
    [SerializeField] private LayerMask m_OpaqueLayerMask = -1;
    [SerializeField] private LayerMask m_TransparentLayerMask = -1;
    [SerializeField] private bool m_ShadowTransparentReceive = true;
    [SerializeField] private RenderingMode m_RenderingMode = RenderingMode.Forward;
    [SerializeField] private DepthPrimingMode m_DepthPrimingMode = DepthPrimingMode.Disabled;
    [SerializeField] private CopyDepthMode m_CopyDepthMode = CopyDepthMode.AfterTransparents;
    [SerializeField] private IntermediateTextureMode m_IntermediateTextureMode = IntermediateTextureMode.Always;

    public LayerMask opaqueLayerMask { get => m_OpaqueLayerMask; set => Set(ref m_OpaqueLayerMask, value); }
    public LayerMask transparentLayerMask { get => m_TransparentLayerMask; set => Set(ref m_TransparentLayerMask, value); }
    public bool shadowTransparentReceive { get => m_ShadowTransparentReceive; set => Set(ref m_ShadowTransparentReceive, value); }
    public RenderingMode renderingMode { get => m_RenderingMode; set => Set(ref m_RenderingMode, value); }
    public DepthPrimingMode depthPrimingMode { get => m_DepthPrimingMode; set => Set(ref m_DepthPrimingMode, value); }
    public CopyDepthMode copyDepthMode { get => m_CopyDepthMode; set => Set(ref m_CopyDepthMode, value); }
    public IntermediateTextureMode intermediateTextureMode { get => m_IntermediateTextureMode; set => Set(ref m_IntermediateTextureMode, value); }

    protected override ScriptableRenderer Create() => new UniversalRenderer(this);

    private void Set<T>(ref T field, T value)
    {
        field = value;
        SetDirty();
    }
}
