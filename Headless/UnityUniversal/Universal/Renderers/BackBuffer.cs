using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering.Universal;

/// <summary>The screen, or the camera's texture.</summary>
internal static class BackBuffer
{
    public static void Import(RenderGraph graph, ContextContainer frame, bool clears)
    {
        UniversalCameraData camera = frame.Get<UniversalCameraData>();
        UniversalResourceData resources = frame.Get<UniversalResourceData>();
        var clear = new ImportResourceParams { clearOnFirstUse = clears, clearColor = camera.backgroundColor };
        if (camera.targetTexture is { } texture && texture != null)
        {
            RTHandle handle = RTHandles.Alloc(texture);
            resources.backBufferColor = graph.ImportTexture(handle, clear);
            resources.backBufferDepth = graph.ImportTexture(handle, clear);
            return;
        }

        var info = new RenderTargetInfo { width = Screen.width, height = Screen.height, volumeDepth = 1, msaaSamples = 1, format = camera.cameraTargetDescriptor.graphicsFormat };
        RTHandle screen = RTHandles.Alloc(BuiltinRenderTextureType.CameraTarget, "Backbuffer color");
        resources.backBufferColor = graph.ImportTexture(screen, info, clear);
        info.format = GraphicsFormat.D32_SFloat;
        resources.backBufferDepth = graph.ImportTexture(RTHandles.Alloc(BuiltinRenderTextureType.CameraTarget, "Backbuffer depth"), info, clear);
    }
}
