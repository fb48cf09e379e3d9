using System;
using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering.Universal;

/// <summary>Colour and depth of a base camera, which the overlay cameras of its stack draw into as well.</summary>
internal sealed class StackTargets : IDisposable
{
    private RTHandle? color;
    private RTHandle? depth;

    public void Import(RenderGraph graph, ContextContainer frame, bool clearsColor, bool clearsDepth)
    {
        UniversalCameraData camera = frame.Get<UniversalCameraData>();
        UniversalResourceData resources = frame.Get<UniversalResourceData>();
        RenderTextureDescriptor desc = camera.cameraTargetDescriptor;
        if (camera.renderType == CameraRenderType.Base)
        {
            Fit(desc);
        }

        resources.cameraColor = graph.ImportTexture(color!, new ImportResourceParams { clearOnFirstUse = clearsColor, clearColor = camera.backgroundColor });
        resources.cameraDepth = graph.ImportTexture(depth!, new ImportResourceParams { clearOnFirstUse = clearsDepth });
    }

    public void Dispose()
    {
        color?.Release();
        depth?.Release();
        (color, depth) = (null, null);
    }

    private void Fit(RenderTextureDescriptor desc)
    {
        RenderTexture? there = color?.rt;
        if (there != null && there.width == desc.width && there.height == desc.height && there.antiAliasing == desc.msaaSamples
            && there.graphicsFormat == desc.graphicsFormat && there.volumeDepth == desc.volumeDepth)
        {
            return;
        }

        Dispose();
        RenderTextureDescriptor colors = desc;
        colors.depthBufferBits = 0;
        color = RTHandles.Alloc(colors, FilterMode.Bilinear, TextureWrapMode.Clamp, name: "_CameraTargetAttachmentA");
        RenderTextureDescriptor depths = desc;
        depths.graphicsFormat = Experimental.Rendering.GraphicsFormat.None;
        depth = RTHandles.Alloc(depths, FilterMode.Point, TextureWrapMode.Clamp, name: "_CameraDepthAttachment");
    }
}
