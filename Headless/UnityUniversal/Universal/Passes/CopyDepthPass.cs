using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering.Universal;

/// <summary>The depth texture as a copy of the camera's depth.</summary>
internal static class CopyDepthPass
{
    private static readonly int Attachment = Shader.PropertyToID("_CameraDepthAttachment");
    private static readonly int Texture = Shader.PropertyToID("_CameraDepthTexture");
    private static Material? material;

    public static void Record(RenderGraph graph, ContextContainer frame)
    {
        UniversalResourceData resources = frame.Get<UniversalResourceData>();
        using IRasterRenderGraphBuilder builder = graph.AddRasterRenderPass("Copy Depth", out Data data);
        data.Source = resources.activeDepthTexture;
        builder.UseTexture(data.Source);
        builder.SetRenderAttachment(resources.cameraDepthTexture, 0, AccessFlags.WriteAll);
        builder.SetGlobalTextureAfterPass(resources.cameraDepthTexture, Texture);
        builder.AllowPassCulling(false);
        builder.AllowGlobalStateModification(true);
        builder.SetRenderFunc(static (Data d, RasterGraphContext context) =>
        {
            if (material == null)
            {
                material = new Material(UniversalShaders.Find("Hidden/Universal Render Pipeline/CopyDepth")) { hideFlags = HideFlags.HideAndDontSave };
            }

            context.cmd.SetGlobalTexture(Attachment, d.Source, RenderTextureSubElement.Depth);
            Blitter.BlitTexture(context.cmd, new Vector4(1f, 1f, 0f, 0f), material, 0);
        });
    }

    private sealed class Data
    {
        public TextureHandle Source { get; set; }
    }
}
