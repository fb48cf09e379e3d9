namespace UnityEngine.Rendering.RenderGraphModule;

/// <summary>A texture of the graph that is recorded or run now; of no meaning in the next.</summary>
public readonly struct TextureHandle
{
    private readonly GraphTexture? texture;

    internal TextureHandle(GraphTexture texture) => this.texture = texture;

    public static TextureHandle nullHandle => default;

    internal GraphTexture? Texture => texture is { IsAlive: true } ? texture : null;

    public static implicit operator RTHandle?(TextureHandle texture) => texture.Texture?.Handle;

    public static implicit operator Texture?(TextureHandle texture) => texture.Texture?.Handle;

    public static implicit operator RenderTexture?(TextureHandle texture) => texture.Texture?.Handle;

    public static implicit operator RenderTargetIdentifier(TextureHandle texture) => texture.Texture?.Handle ?? default(RenderTargetIdentifier);

    public bool IsValid() => Texture is not null;

    public TextureDesc GetDescriptor(RenderGraph renderGraph) => renderGraph.GetTextureDesc(this);
}
