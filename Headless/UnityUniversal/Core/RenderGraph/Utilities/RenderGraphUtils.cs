using System.Runtime.CompilerServices;

namespace UnityEngine.Rendering.RenderGraphModule.Util;

/// <summary>Passes that most features need.</summary>
public static class RenderGraphUtils
{
    public enum BlitFilterMode
    {
        ClampNearest = 0,
        ClampBilinear = 1,
    }

    public static void AddCopyPass(
        this RenderGraph graph, TextureHandle source, TextureHandle destination, int sourceSlice = 0, int destinationSlice = 0, int sourceMip = 0,
        int destinationMip = 0, string passName = "Copy Pass Utility", [CallerFilePath] string file = "", [CallerLineNumber] int line = 0) =>
        AddBlitPass(graph, source, destination, Vector2.one, Vector2.zero, sourceMip: sourceMip, filterMode: BlitFilterMode.ClampNearest, passName: passName);

    public static void AddBlitPass(
        this RenderGraph graph, TextureHandle source, TextureHandle destination, Vector2 scale, Vector2 offset, int sourceSlice = 0, int destinationSlice = 0,
        int numSlices = -1, int sourceMip = 0, int destinationMip = 0, int numMips = 1, BlitFilterMode filterMode = BlitFilterMode.ClampBilinear,
        string passName = "Blit Pass Utility", [CallerFilePath] string file = "", [CallerLineNumber] int line = 0)
    {
        using IRasterRenderGraphBuilder builder = graph.AddRasterRenderPass(passName, out BlitData data);
        (data.Source, data.ScaleBias, data.Mip, data.IsBilinear) = (source, new Vector4(scale.x, scale.y, offset.x, offset.y), sourceMip, filterMode == BlitFilterMode.ClampBilinear);
        builder.UseTexture(source);
        builder.SetRenderAttachment(destination, 0);
        builder.SetRenderFunc((BlitData d, RasterGraphContext context) => Blitter.BlitTexture(context.cmd, d.Source!, d.ScaleBias, d.Mip, d.IsBilinear));
    }

    public static void AddBlitPass(
        this RenderGraph graph, BlitMaterialParameters blitParameters, string passName = "Blit Pass Utility w. Material", [CallerFilePath] string file = "",
        [CallerLineNumber] int line = 0)
    {
        using IRasterRenderGraphBuilder builder = graph.AddRasterRenderPass(passName, out MaterialData data);
        data.Parameters = blitParameters;
        if (blitParameters.source.IsValid())
        {
            builder.UseTexture(blitParameters.source);
        }

        builder.SetRenderAttachment(blitParameters.destination, 0);
        builder.SetRenderFunc(static (MaterialData d, RasterGraphContext context) =>
        {
            BlitMaterialParameters p = d.Parameters;
            var scaleBias = new Vector4(p.scale.x, p.scale.y, p.offset.x, p.offset.y);
            if (p.source.IsValid())
            {
                Blitter.BlitTexture(context.cmd, p.source!, scaleBias, p.material, p.shaderPass);
            }
            else
            {
                Blitter.BlitTexture(context.cmd, scaleBias, p.material, p.shaderPass);
            }
        });
    }

    public struct BlitMaterialParameters
    {
        public TextureHandle source;
        public TextureHandle destination;
        public Vector2 scale;
        public Vector2 offset;
        public Material material;
        public int shaderPass;

        public BlitMaterialParameters(TextureHandle source, TextureHandle destination, Material material, int shaderPass)
            : this(source, destination, Vector2.one, Vector2.zero, material, shaderPass)
        {
        }

        public BlitMaterialParameters(TextureHandle source, TextureHandle destination, Vector2 scale, Vector2 offset, Material material, int shaderPass) =>
            (this.source, this.destination, this.scale, this.offset, this.material, this.shaderPass) = (source, destination, scale, offset, material, shaderPass);
    }

    private sealed class BlitData
    {
        public TextureHandle Source { get; set; }
        public Vector4 ScaleBias { get; set; }
        public float Mip { get; set; }
        public bool IsBilinear { get; set; }
    }

    private sealed class MaterialData
    {
        public BlitMaterialParameters Parameters { get; set; }
    }
}
