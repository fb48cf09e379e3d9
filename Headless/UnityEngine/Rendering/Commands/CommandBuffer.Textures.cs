using Headless.Engine;

namespace UnityEngine.Rendering;

public partial class CommandBuffer
{
    public void Blit(Texture source, RenderTargetIdentifier dest) => Blit(new RenderTargetIdentifier(source), dest);

    public void Blit(Texture source, RenderTargetIdentifier dest, Vector2 scale, Vector2 offset) =>
        Blit(new RenderTargetIdentifier(source), dest, scale, offset);

    public void Blit(Texture source, RenderTargetIdentifier dest, Material mat) => Blit(source, dest, mat, -1);

    public void Blit(Texture source, RenderTargetIdentifier dest, Material mat, int pass) => Blit(new RenderTargetIdentifier(source), dest, mat, pass);

    public void Blit(RenderTargetIdentifier source, RenderTargetIdentifier dest) => Blit(source, dest, Vector2.one, Vector2.zero);

    public void Blit(RenderTargetIdentifier source, RenderTargetIdentifier dest, Vector2 scale, Vector2 offset) =>
        AddBlit(source, dest, null, -1, scale, offset);

    public void Blit(RenderTargetIdentifier source, RenderTargetIdentifier dest, Material mat) => Blit(source, dest, mat, -1);

    public void Blit(RenderTargetIdentifier source, RenderTargetIdentifier dest, Material mat, int pass) =>
        AddBlit(source, dest, mat, pass, Vector2.one, Vector2.zero);

    // The destination stays the render target.
    void AddBlit(RenderTargetIdentifier source, RenderTargetIdentifier dest, Material? mat, int pass, Vector2 scale, Vector2 offset) => Add(c =>
    {
        DrawTarget? target = c.Target(dest);
        Blitter.Blit(Source(c, source), target, mat, pass, scale, offset);
        SwitchTo(target);
    });

    public void CopyTexture(RenderTargetIdentifier src, RenderTargetIdentifier dst) => Add(c => TextureCopies.Copy(c.Texture(src), c.Texture(dst)));

    public void CopyTexture(RenderTargetIdentifier src, int srcElement, RenderTargetIdentifier dst, int dstElement) =>
        CopyTexture(src, srcElement, 0, dst, dstElement, 0);

    public void CopyTexture(RenderTargetIdentifier src, int srcElement, int srcMip, RenderTargetIdentifier dst, int dstElement, int dstMip) =>
        Add(c => TextureCopies.Copy(c.Texture(src), srcElement, srcMip, c.Texture(dst), dstElement, dstMip));

    public void GenerateMips(RenderTexture rt)
    {
        Require(rt);
        Add(_ => rt.GenerateMips());
    }

    public void GenerateMips(RenderTargetIdentifier rt) => Add(c => (c.Texture(rt) as RenderTexture)?.GenerateMips());

    /// <summary>Without effect: a depth texture is read as it is, or compared, by the sampler that the shader declares for it.</summary>
    public void SetShadowSamplingMode(RenderTargetIdentifier shadowmap, ShadowSamplingMode mode)
    {
    }

    public void ResolveAntiAliasedSurface(RenderTexture rt, RenderTexture? target = null)
    {
        Require(rt);
        Add(_ =>
        {
            // The texture itself is resolved whenever drawing to it ends.
            if (target != null)
            {
                TextureCopies.Copy(rt, target);
            }
        });
    }

    private static Texture? Source(CommandContext context, in RenderTargetIdentifier id) =>
        id.Builtin is BuiltinRenderTextureType.CameraTarget or BuiltinRenderTextureType.CurrentActive
            ? BorrowedTexture.Of(context.Target(id))
            : context.Texture(id);
}
