using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering.Universal;

/// <summary>Brings the picture to the camera's rectangle of the screen, or to its texture.</summary>
internal static class FinalBlitPass
{
    public static void Record(RenderGraph graph, ContextContainer frame)
    {
        UniversalResourceData resources = frame.Get<UniversalResourceData>();
        UniversalCameraData camera = frame.Get<UniversalCameraData>();
        using IRasterRenderGraphBuilder builder = graph.AddRasterRenderPass("Final Blit", out Data data);

        // The screen's first row is the top of the picture, a texture's the bottom.
        bool turns = SystemInfo.graphicsUVStartsAtTop && camera.targetTexture == null;
        data.ScaleBias = turns ? new Vector4(1f, -1f, 0f, 1f) : new Vector4(1f, 1f, 0f, 0f);
        (data.Source, data.Rect, data.IsScaled) = (resources.cameraColor, camera.PixelRect, camera.renderScale != 1f);
        builder.UseTexture(data.Source);
        builder.SetRenderAttachment(resources.backBufferColor, 0);
        builder.AllowPassCulling(false);
        builder.AllowGlobalStateModification(true);
        builder.SetRenderFunc(static (Data d, RasterGraphContext context) =>
        {
            context.cmd.SetViewport(d.Rect);
            Blitter.BlitTexture(context.cmd, d.Source!, d.ScaleBias, 0f, d.IsScaled);
        });
        resources.isActiveTargetBackBuffer = true;
    }

    private sealed class Data
    {
        public TextureHandle Source { get; set; }
        public Vector4 ScaleBias { get; set; }
        public Rect Rect { get; set; }
        public bool IsScaled { get; set; }
    }
}
