using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering.Universal;

/// <summary>Depth of opaque objects, with their normals where those are asked for.</summary>
internal static class DepthPrepass
{
    private static readonly ShaderTagId[] DepthTags = [new("DepthOnly")];
    private static readonly ShaderTagId[] NormalTags = [new("DepthNormals"), new("DepthNormalsOnly")];
    private static readonly int DepthTexture = Shader.PropertyToID("_CameraDepthTexture");
    private static readonly int NormalsTexture = Shader.PropertyToID("_CameraNormalsTexture");

    /// <param name="depth">The camera's depth, or the depth texture.</param>
    /// <param name="isTexture">Whether it is the texture, and shaders may read it from now on.</param>
    public static void Record(RenderGraph graph, ContextContainer frame, TextureHandle depth, bool normals, bool isTexture)
    {
        UniversalResourceData resources = frame.Get<UniversalResourceData>();
        UniversalRenderingData rendering = frame.Get<UniversalRenderingData>();
        using IRasterRenderGraphBuilder builder = graph.AddRasterRenderPass(normals ? "DepthNormals Prepass" : "Depth Prepass", out Data data);
        DrawingSettings drawing = Drawing.Settings(normals ? NormalTags : DepthTags, frame, frame.Get<UniversalCameraData>().defaultOpaqueSortFlags);
        drawing.perObjectData = PerObjectData.None;
        data.List = graph.CreateRendererList(new RendererListParams(rendering.cullResults, drawing, new FilteringSettings(RenderQueueRange.opaque, rendering.opaqueLayerMask)));
        builder.UseRendererList(data.List);
        builder.SetRenderAttachmentDepth(depth);
        if (normals)
        {
            builder.SetRenderAttachment(resources.cameraNormalsTexture, 0);
            builder.SetGlobalTextureAfterPass(resources.cameraNormalsTexture, NormalsTexture);
        }

        if (isTexture)
        {
            builder.SetGlobalTextureAfterPass(depth, DepthTexture);
        }

        builder.AllowPassCulling(false);
        builder.AllowGlobalStateModification(true);
        builder.SetRenderFunc(static (Data d, RasterGraphContext context) => context.cmd.DrawRendererList(d.List));
    }

    private sealed class Data
    {
        public RendererListHandle List { get; set; }
    }
}
