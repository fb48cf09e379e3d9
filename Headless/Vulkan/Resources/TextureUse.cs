namespace Headless.Vulkan;

/// <summary>What a texture may be bound as; copying to and from it is always allowed for one sample.</summary>
[Flags]
public enum TextureUse
{
    /// <summary>Texture2D, Texture3D, ... in shaders.</summary>
    Sampled = 1,

    /// <summary>RWTexture2D, RWTexture3D in shaders.</summary>
    Storage = 2,

    /// <summary>Color or, by format, depth target.</summary>
    RenderTarget = 4,
}
