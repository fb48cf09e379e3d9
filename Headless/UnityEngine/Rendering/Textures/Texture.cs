using System.Linq;
using System;
using Headless.Engine;
using Headless.Vulkan;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace UnityEngine;

public class Texture : Object
{
    public static readonly int GenerateAllMips = -1;

    private TextureWrapMode wrapV;
    private TextureWrapMode wrapW;
    private uint updates;

    protected Texture()
    {
    }

    public static AnisotropicFiltering anisotropicFiltering { get; set; } = AnisotropicFiltering.Enable;

    public static ulong currentTextureMemory => TextureMemory.Bytes;

    public virtual int width
    {
        get => Size.Width;
        set => throw new NotSupportedException($"The width of texture '{name}' can't be changed.");
    }

    public virtual int height
    {
        get => Size.Height;
        set => throw new NotSupportedException($"The height of texture '{name}' can't be changed.");
    }

    public virtual TextureDimension dimension
    {
        get => TextureDimension.Tex2D;
        set => throw new NotSupportedException($"The dimension of texture '{name}' can't be changed.");
    }

    public virtual GraphicsFormat graphicsFormat => GraphicsFormat.None;

    public virtual bool isReadable => false;
    public int mipmapCount => Math.Max(1, MipLevels);
    public FilterMode filterMode { get; set; } = FilterMode.Bilinear;
    public int anisoLevel { get; set; } = 1;
    public float mipMapBias { get; set; }
    public Vector2 texelSize => new(1f / width, 1f / height);
    public bool isDataSRGB => TextureFormats.IsSrgb(graphicsFormat);
    public uint updateCount => updates;
    public Hash128 imageContentsHash { get; set; }

    public TextureWrapMode wrapMode
    {
        get => wrapModeU;
        set => (wrapModeU, wrapV, wrapW) = (value, value, value);
    }

    public TextureWrapMode wrapModeU { get; set; }

    public TextureWrapMode wrapModeV
    {
        get => wrapV;
        set => wrapV = value;
    }

    public TextureWrapMode wrapModeW
    {
        get => wrapW;
        set => wrapW = value;
    }

    internal virtual (int Width, int Height) Size => (1, 1);
    internal virtual int MipLevels => 1;

    /// <summary>True where row 0 in memory is the bottom of the picture: every texture but the screen.</summary>
    internal virtual bool BottomFirst => true;

    public void IncrementUpdateCount() => updates++;

    /// <summary>The texture that shaders read; null when it cannot be made.</summary>
    internal virtual GpuTexture? DeviceTexture(RenderTextureSubElement element) => null;
}
