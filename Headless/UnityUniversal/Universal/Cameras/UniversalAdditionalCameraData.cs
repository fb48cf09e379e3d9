using System.Collections.Generic;

namespace UnityEngine.Rendering.Universal;

/// <summary>The pipeline's own settings of a camera; the names of the fields are those of Unity's scenes.</summary>
[DisallowMultipleComponent]
[RequireComponent(typeof(Camera))]
public class UniversalAdditionalCameraData : MonoBehaviour
{
    [SerializeField] private bool m_RenderShadows = true;
    [SerializeField] private CameraOverrideOption m_RequiresDepthTextureOption = CameraOverrideOption.UsePipelineSettings;
    [SerializeField] private CameraOverrideOption m_RequiresOpaqueTextureOption = CameraOverrideOption.UsePipelineSettings;
    [SerializeField] private CameraRenderType m_CameraType = CameraRenderType.Base;
    [SerializeField] private List<Camera> m_Cameras = [];
    [SerializeField] private int m_RendererIndex = -1;
    [SerializeField] private LayerMask m_VolumeLayerMask = 1;
    [SerializeField] private Transform? m_VolumeTrigger;
    [SerializeField] private bool m_RenderPostProcessing;
    [SerializeField] private AntialiasingMode m_Antialiasing = AntialiasingMode.None;
    [SerializeField] private AntialiasingQuality m_AntialiasingQuality = AntialiasingQuality.High;
    [SerializeField] private bool m_StopNaN;
    [SerializeField] private bool m_Dithering;
    [SerializeField] private bool m_ClearDepth = true;
    [SerializeField] private bool m_AllowXRRendering = true;

    public bool renderShadows { get => m_RenderShadows; set => m_RenderShadows = value; }
    public CameraOverrideOption requiresDepthOption { get => m_RequiresDepthTextureOption; set => m_RequiresDepthTextureOption = value; }
    public CameraOverrideOption requiresColorOption { get => m_RequiresOpaqueTextureOption; set => m_RequiresOpaqueTextureOption = value; }

    public bool requiresDepthTexture
    {
        get => Resolve(m_RequiresDepthTextureOption, UniversalRenderPipeline.asset?.supportsCameraDepthTexture ?? false);
        set => m_RequiresDepthTextureOption = value ? CameraOverrideOption.On : CameraOverrideOption.Off;
    }

    public bool requiresColorTexture
    {
        get => Resolve(m_RequiresOpaqueTextureOption, UniversalRenderPipeline.asset?.supportsCameraOpaqueTexture ?? false);
        set => m_RequiresOpaqueTextureOption = value ? CameraOverrideOption.On : CameraOverrideOption.Off;
    }

    public CameraRenderType renderType { get => m_CameraType; set => m_CameraType = value; }

    /// <summary>Null for overlay cameras: only a base camera has a stack.</summary>
    public List<Camera>? cameraStack
    {
        get
        {
            if (m_CameraType == CameraRenderType.Base)
            {
                return m_Cameras;
            }

            Debug.LogWarning($"{name}: This camera is of Overlay type. Only Base cameras can have a camera stack.");
            return null;
        }
    }

    public bool clearDepth => m_ClearDepth;
    public LayerMask volumeLayerMask { get => m_VolumeLayerMask; set => m_VolumeLayerMask = value; }
    public Transform? volumeTrigger { get => m_VolumeTrigger; set => m_VolumeTrigger = value; }
    public bool renderPostProcessing { get => m_RenderPostProcessing; set => m_RenderPostProcessing = value; }
    public AntialiasingMode antialiasing { get => m_Antialiasing; set => m_Antialiasing = value; }
    public AntialiasingQuality antialiasingQuality { get => m_AntialiasingQuality; set => m_AntialiasingQuality = value; }
    public bool stopNaN { get => m_StopNaN; set => m_StopNaN = value; }
    public bool dithering { get => m_Dithering; set => m_Dithering = value; }
    public bool allowXRRendering { get => m_AllowXRRendering; set => m_AllowXRRendering = value; }

    /// <summary>Null without a URP asset.</summary>
    public ScriptableRenderer? scriptableRenderer => UniversalRenderPipeline.asset is { } asset ? asset.GetRenderer(m_RendererIndex) : null;

    public void SetRenderer(int index) => m_RendererIndex = index;

    private static bool Resolve(CameraOverrideOption option, bool pipeline) =>
        option == CameraOverrideOption.UsePipelineSettings ? pipeline : option == CameraOverrideOption.On;
}
