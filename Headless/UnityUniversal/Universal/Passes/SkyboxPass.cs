using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering.Universal;

internal static class SkyboxPass
{
    public static void Record(RenderGraph graph, ContextContainer frame)
    {
        UniversalCameraData camera = frame.Get<UniversalCameraData>();
        UniversalResourceData resources = frame.Get<UniversalResourceData>();
        if (RenderSettings.skybox == null)
        {
            return;
        }

        using IRasterRenderGraphBuilder builder = graph.AddRasterRenderPass("Draw Skybox", out Data data);
        data.List = graph.CreateSkyboxRendererList(camera.camera, camera.GetProjectionMatrix(), camera.GetViewMatrix());
        builder.UseRendererList(data.List);
        builder.SetRenderAttachment(resources.activeColorTexture, 0);
        builder.SetRenderAttachmentDepth(resources.activeDepthTexture);
        builder.AllowPassCulling(false);
        builder.SetRenderFunc(static (Data d, RasterGraphContext context) => context.cmd.DrawRendererList(d.List));
    }

    private sealed class Data
    {
        public RendererListHandle List { get; set; }
    }
}
