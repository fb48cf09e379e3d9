namespace UnityEngine.Rendering;

/// <summary>Copies with a triangle over the target. Shaders of users' passes find the source as _BlitTexture.</summary>
public static class Blitter
{
    private static readonly int Source = Shader.PropertyToID("_BlitTexture");
    private static readonly int ScaleBias = Shader.PropertyToID("_BlitScaleBias");
    private static readonly int MipLevel = Shader.PropertyToID("_BlitMipLevel");
    private static readonly Vector4 Whole = new(1f, 1f, 0f, 0f);
    private static Material? copy;

    public static Material GetBlitMaterial(TextureDimension dimension, bool singleSlice = false)
    {
        if (copy == null)
        {
            copy = new Material(CoreShaders.Find("Hidden/Universal/CoreBlit")) { hideFlags = HideFlags.HideAndDontSave };
        }

        return copy;
    }

    public static void BlitTexture(CommandBuffer cmd, RTHandle source, Vector4 scaleBias, float mipLevel, bool bilinear) =>
        Draw(cmd, source.nameID, scaleBias, mipLevel, GetBlitMaterial(TextureDimension.Tex2D), bilinear ? 1 : 0);

    public static void BlitTexture(RasterCommandBuffer cmd, RTHandle source, Vector4 scaleBias, float mipLevel, bool bilinear) =>
        BlitTexture(cmd.Wrapped, source, scaleBias, mipLevel, bilinear);

    public static void BlitTexture(CommandBuffer cmd, RTHandle source, Vector4 scaleBias, Material material, int pass) =>
        Draw(cmd, source.nameID, scaleBias, 0f, material, pass);

    public static void BlitTexture(RasterCommandBuffer cmd, RTHandle source, Vector4 scaleBias, Material material, int pass) =>
        BlitTexture(cmd.Wrapped, source, scaleBias, material, pass);

    public static void BlitTexture(CommandBuffer cmd, RenderTargetIdentifier source, Vector4 scaleBias, Material material, int pass) =>
        Draw(cmd, source, scaleBias, 0f, material, pass);

    public static void BlitTexture(CommandBuffer cmd, Vector4 scaleBias, Material material, int pass) => Draw(cmd, null, scaleBias, 0f, material, pass);

    public static void BlitTexture(RasterCommandBuffer cmd, Vector4 scaleBias, Material material, int pass) => BlitTexture(cmd.Wrapped, scaleBias, material, pass);

    public static void BlitCameraTexture(CommandBuffer cmd, RTHandle source, RTHandle destination, float mipLevel = 0f, bool bilinear = false)
    {
        cmd.SetRenderTarget(destination);
        BlitTexture(cmd, source, Whole, mipLevel, bilinear);
    }

    public static void BlitCameraTexture(CommandBuffer cmd, RTHandle source, RTHandle destination, Material material, int pass)
    {
        cmd.SetRenderTarget(destination);
        BlitTexture(cmd, source, Whole, material, pass);
    }

    public static void BlitCameraTexture(CommandBuffer cmd, RTHandle source, RTHandle destination, Vector4 scaleBias, float mipLevel = 0f, bool bilinear = false)
    {
        cmd.SetRenderTarget(destination);
        BlitTexture(cmd, source, scaleBias, mipLevel, bilinear);
    }

    public static void Cleanup()
    {
        Object.DestroyImmediate(copy);
        copy = null;
    }

    private static void Draw(CommandBuffer cmd, RenderTargetIdentifier? source, Vector4 scaleBias, float mipLevel, Material material, int pass)
    {
        if (source is { } texture)
        {
            cmd.SetGlobalTexture(Source, texture);
        }

        var block = new MaterialPropertyBlock();
        block.SetVector(ScaleBias, scaleBias);
        block.SetFloat(MipLevel, mipLevel);
        cmd.DrawProcedural(Matrix4x4.identity, material, pass, MeshTopology.Triangles, 3, 1, block);
    }
}
