using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering.Universal;

/// <summary>Opaque and transparent objects, by the LightModes that the pipeline draws forward.</summary>
internal static class ObjectsPass
{
    private static readonly ShaderTagId[] Tags = [new("SRPDefaultUnlit"), new("UniversalForward"), new("UniversalForwardOnly")];
    private static readonly int PassData = Shader.PropertyToID("_DrawObjectPassData");
    private static readonly int ScaleBias = Shader.PropertyToID("_ScaleBiasRt");
    private static readonly int AlphaToMask = Shader.PropertyToID("_AlphaToMaskAvailable");

    /// <param name="primed">Depth is there already: only what lies at it is shaded.</param>
    public static void RecordOpaque(RenderGraph graph, ContextContainer frame, bool primed)
    {
        UniversalRenderingData rendering = frame.Get<UniversalRenderingData>();
        var filter = new FilteringSettings(RenderQueueRange.opaque, rendering.opaqueLayerMask);
        Record(graph, frame, "Draw Opaque Objects", filter, frame.Get<UniversalCameraData>().defaultOpaqueSortFlags, true, primed);
    }

    public static void RecordTransparent(RenderGraph graph, ContextContainer frame)
    {
        UniversalRenderingData rendering = frame.Get<UniversalRenderingData>();
        var filter = new FilteringSettings(RenderQueueRange.transparent, rendering.transparentLayerMask);
        Record(graph, frame, "Draw Transparent Objects", filter, SortingCriteria.CommonTransparent, false, false);
    }

    public static void RecordRenderObject(RenderGraph graph, ContextContainer frame)
    {
        using IRasterRenderGraphBuilder builder = graph.AddRasterRenderPass("Invoke OnRenderObject", out Data _);
        UniversalResourceData resources = frame.Get<UniversalResourceData>();
        builder.SetRenderAttachment(resources.activeColorTexture, 0);
        builder.SetRenderAttachmentDepth(resources.activeDepthTexture);
        builder.AllowPassCulling(false);
        builder.AllowGlobalStateModification(true);
        builder.SetRenderFunc(static (Data _, RasterGraphContext context) => context.cmd.InvokeOnRenderObjectCallbacks());
    }

    private static void Record(
        RenderGraph graph, ContextContainer frame, string name, FilteringSettings filter, SortingCriteria sorting, bool isOpaque, bool primed)
    {
        UniversalResourceData resources = frame.Get<UniversalResourceData>();
        UniversalCameraData camera = frame.Get<UniversalCameraData>();
        using IRasterRenderGraphBuilder builder = graph.AddRasterRenderPass(name, out Data data);
        var list = new RendererListParams(frame.Get<UniversalRenderingData>().cullResults, Drawing.Settings(Tags, frame, sorting), filter);
        if (primed)
        {
            Primed.Apply(ref list);
        }

        (data.List, data.IsOpaque, data.IsFlipped) = (graph.CreateRendererList(list), isOpaque, camera.IsCameraProjectionMatrixFlipped());
        data.AlphaToMask = camera.cameraTargetDescriptor.msaaSamples > 1 && isOpaque ? 1f : 0f;
        builder.UseRendererList(data.List);
        builder.UseAllGlobalTextures(true);
        builder.SetRenderAttachment(resources.activeColorTexture, 0);
        builder.SetRenderAttachmentDepth(resources.activeDepthTexture);
        builder.AllowPassCulling(false);
        builder.AllowGlobalStateModification(true);
        builder.SetRenderFunc(static (Data d, RasterGraphContext context) =>
        {
            context.cmd.SetGlobalVector(PassData, new Vector4(0f, 0f, 0f, d.IsOpaque ? 1f : 0f));
            context.cmd.SetGlobalVector(ScaleBias, d.IsFlipped ? new Vector4(-1f, 1f, -1f, 1f) : new Vector4(1f, 0f, 1f, 1f));
            context.cmd.SetGlobalFloat(AlphaToMask, d.AlphaToMask);
            context.cmd.DrawRendererList(d.List);
        });
    }

    private sealed class Data
    {
        public RendererListHandle List { get; set; }
        public bool IsOpaque { get; set; }
        public bool IsFlipped { get; set; }
        public float AlphaToMask { get; set; }
    }
}
