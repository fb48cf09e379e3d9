using System;
using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering.Universal;

/// <summary>The opaque texture: the camera's colour before transparents, at full, half or quarter size.</summary>
internal static class CopyColorPass
{
    private static readonly int Texture = Shader.PropertyToID("_CameraOpaqueTexture");
    private static readonly int SampleOffset = Shader.PropertyToID("_SampleOffset");
    private static Material? box;

    public static void Record(RenderGraph graph, ContextContainer frame, Downsampling downsampling)
    {
        UniversalResourceData resources = frame.Get<UniversalResourceData>();
        RenderTextureDescriptor camera = frame.Get<UniversalCameraData>().cameraTargetDescriptor;
        int divisor = downsampling switch { Downsampling.None => 1, Downsampling._2xBilinear => 2, _ => 4 };
        resources.cameraOpaqueTexture = graph.CreateTexture(new TextureDesc(Math.Max(1, camera.width / divisor), Math.Max(1, camera.height / divisor))
        {
            slices = camera.volumeDepth,
            dimension = camera.dimension,
            format = camera.graphicsFormat,
            name = "_CameraOpaqueTexture",
            filterMode = downsampling == Downsampling.None ? FilterMode.Point : FilterMode.Bilinear,
        });
        using IRasterRenderGraphBuilder builder = graph.AddRasterRenderPass("Copy Color", out Data data);
        (data.Source, data.Downsampling) = (resources.activeColorTexture, downsampling);
        builder.UseTexture(data.Source);
        builder.SetRenderAttachment(resources.cameraOpaqueTexture, 0, AccessFlags.WriteAll);
        builder.SetGlobalTextureAfterPass(resources.cameraOpaqueTexture, Texture);
        builder.AllowPassCulling(false);
        builder.AllowGlobalStateModification(true);
        builder.SetRenderFunc(static (Data d, RasterGraphContext context) => Copy(d, context.cmd));
    }

    private static void Copy(Data data, RasterCommandBuffer cmd)
    {
        var whole = new Vector4(1f, 1f, 0f, 0f);
        if (data.Downsampling != Downsampling._4xBox)
        {
            Blitter.BlitTexture(cmd, data.Source!, whole, 0f, data.Downsampling != Downsampling.None);
            return;
        }

        if (box == null)
        {
            box = new Material(UniversalShaders.Find("Hidden/Universal Render Pipeline/Sampling")) { hideFlags = HideFlags.HideAndDontSave };
        }

        box.SetFloat(SampleOffset, 2f);
        Blitter.BlitTexture(cmd, data.Source!, whole, box, 0);
    }

    private sealed class Data
    {
        public TextureHandle Source { get; set; }
        public Downsampling Downsampling { get; set; }
    }
}
