using System;
using UnityEngine.Experimental.Rendering;

namespace UnityEngine.Rendering.Universal;

/// <summary>What a camera's components and the asset say, together.</summary>
internal static class CameraSetup
{
    /// <summary>A scale that is as near to 1 is taken for 1.</summary>
    private const float ScaleThreshold = 0.05f;

    public static UniversalCameraData Fill(
        UniversalCameraData data, UniversalRenderPipelineAsset settings, ScriptableRenderer renderer, Camera camera, Camera baseCamera,
        UniversalAdditionalCameraData? additional, bool isLast)
    {
        (data.camera, data.baseCamera, data.renderer) = (camera, baseCamera, renderer);
        data.xrRendering = EyePass.Views > 0;
        data.targetTexture = data.xrRendering ? EyePass.Target : baseCamera.targetTexture;
        (data.cameraType, data.PixelRect) = (baseCamera.cameraType, baseCamera.pixelRect);
        data.isDefaultViewport = baseCamera.rect is { x: 0f, y: 0f, width: >= 1f, height: >= 1f };
        data.isHdrEnabled = baseCamera.allowHDR && settings.supportsHDR;
        bool isUnscaled = baseCamera.cameraType != CameraType.Game || Mathf.Abs(1f - settings.renderScale) < ScaleThreshold;
        data.renderScale = isUnscaled ? 1f : settings.renderScale;
        data.defaultOpaqueSortFlags = baseCamera.opaqueSortMode == OpaqueSortMode.NoDistanceSort
            ? SortingCriteria.SortingLayer | SortingCriteria.RenderQueue | SortingCriteria.OptimizeStateChanges | SortingCriteria.CanvasOrder
            : SortingCriteria.CommonOpaque;
        data.cameraTargetDescriptor = Descriptor(data, settings);

        bool hasShadows = settings.supportsMainLightShadows || settings.supportsAdditionalLightShadows;
        float shadowDistance = Mathf.Min(settings.shadowDistance, camera.farClipPlane);
        data.maxShadowDistance = hasShadows && shadowDistance >= camera.nearClipPlane ? shadowDistance : 0f;
        bool isScene = camera.cameraType == CameraType.SceneView;
        if (additional == null || isScene)
        {
            (data.renderType, data.clearDepth, data.postProcessEnabled) = (CameraRenderType.Base, true, false);
            (data.requiresDepthTexture, data.requiresOpaqueTexture) = (settings.supportsCameraDepthTexture, settings.supportsCameraOpaqueTexture);
            (data.volumeLayerMask, data.volumeTrigger) = (1, null);
        }
        else
        {
            data.renderType = additional.renderType;
            data.clearDepth = additional.renderType == CameraRenderType.Base || additional.clearDepth;
            data.postProcessEnabled = additional.renderPostProcessing;
            data.maxShadowDistance = additional.renderShadows ? data.maxShadowDistance : 0f;
            (data.requiresDepthTexture, data.requiresOpaqueTexture) = (additional.requiresDepthTexture, additional.requiresColorTexture);
            (data.antialiasing, data.antialiasingQuality) = (additional.antialiasing, additional.antialiasingQuality);
            (data.volumeLayerMask, data.volumeTrigger) = (additional.volumeLayerMask, additional.volumeTrigger);
        }

        if (data.renderType == CameraRenderType.Overlay)
        {
            data.requiresOpaqueTexture = false;
        }

        data.resolveFinalTarget = isLast;
        data.SetMatrices(camera.worldToCameraMatrix, Projection(data, camera, camera.projectionMatrix));
        for (int i = 0; i < EyePass.Views; i++)
        {
            data.SetMatrices(EyePass.View(camera, i), Projection(data, camera, EyePass.Projection(camera, i)), i);
        }

        data.worldSpaceCameraPos = EyePass.Views == 1 ? data.GetViewMatrix().inverse.GetColumn(3) : camera.transform.position;
        data.backgroundColor = QualitySettings.activeColorSpace == ColorSpace.Linear ? camera.backgroundColor.linear : camera.backgroundColor;
        return data;
    }

    /// <summary>Overlay cameras draw into the base camera's rectangle, and so with its aspect ratio.</summary>
    private static Matrix4x4 Projection(UniversalCameraData data, Camera camera, Matrix4x4 projection)
    {
        if (data.renderType == CameraRenderType.Overlay && !camera.orthographic && data.PixelRect != camera.pixelRect)
        {
            projection.m00 = projection.m00 * camera.aspect / data.AspectRatio;
        }

        return projection;
    }

    private static RenderTextureDescriptor Descriptor(UniversalCameraData data, UniversalRenderPipelineAsset settings)
    {
        int samples = 1;
        if (EyePass.Views < 2 && data.baseCamera.allowMSAA && settings.msaaSampleCount > 1)
        {
            samples = data.baseCamera.targetTexture != null ? data.baseCamera.targetTexture.antiAliasing : settings.msaaSampleCount;
        }

        var desc = new RenderTextureDescriptor(data.scaledWidth, data.scaledHeight, ColorFormat(data.isHdrEnabled, settings), GraphicsFormat.D32_SFloat)
        {
            msaaSamples = Math.Max(1, samples),
            volumeDepth = Math.Max(1, EyePass.Views),
            dimension = EyePass.Views > 1 ? TextureDimension.Tex2DArray : TextureDimension.Tex2D,
        };
        desc.msaaSamples = SystemInfo.GetRenderTextureSupportedMSAASampleCount(desc);
        return desc;
    }

    private static GraphicsFormat ColorFormat(bool hdr, UniversalRenderPipelineAsset settings)
    {
        if (!hdr)
        {
            return SystemInfo.GetGraphicsFormat(DefaultFormat.LDR);
        }

        return settings.hdrColorBufferPrecision == HDRColorBufferPrecision._32Bits && SystemInfo.SupportsRenderTextureFormat(RenderTextureFormat.RGB111110Float)
            ? GraphicsFormat.B10G11R11_UFloatPack32
            : GraphicsFormat.R16G16B16A16_SFloat;
    }
}
