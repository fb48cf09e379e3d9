using System.Linq;
using Headless.Vulkan;
using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>A device texture that belongs to someone else, as a Texture that shaders can read.</summary>
internal sealed class BorrowedTexture : Texture
{
    private readonly GpuTexture texture;
    private readonly bool bottomFirst;

    public BorrowedTexture(GpuTexture texture, bool bottomFirst)
    {
        this.texture = texture;
        this.bottomFirst = bottomFirst;
        wrapMode = TextureWrapMode.Clamp;
    }

    public override TextureDimension dimension =>
        texture.Description.Dimension == GpuTextureDimension.Texture2DArray ? TextureDimension.Tex2DArray : TextureDimension.Tex2D;

    internal override (int Width, int Height) Size => (texture.Description.Width, texture.Description.Height);
    internal override bool BottomFirst => bottomFirst;

    /// <summary>The color texture of a target, resolved if it is multisampled; of a target without colors, its depth.</summary>
    public static BorrowedTexture? Of(DrawTarget? target)
    {
        GpuTexture? shown = target is null ? null : target.Resolves.FirstOrDefault() ?? target.Colors.FirstOrDefault() ?? target.Depth;
        return shown is null ? null : new BorrowedTexture(shown, target!.Flipped) { hideFlags = HideFlags.HideAndDontSave };
    }

    internal override GpuTexture? DeviceTexture(RenderTextureSubElement element) => texture;
}
