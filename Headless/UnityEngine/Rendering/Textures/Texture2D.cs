using System;
using Headless.Engine;
using Headless.Vulkan;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Texture2D : Texture
{
    private PixelStore store;
    private GpuTexture? device;
    private bool dirty = true;
    private bool readable = true;

    public Texture2D(int width, int height)
        : this(width, height, TextureFormat.RGBA32, true, false)
    {
    }

    public Texture2D(int width, int height, TextureFormat textureFormat, bool mipChain)
        : this(width, height, textureFormat, mipChain, false)
    {
    }

    public Texture2D(int width, int height, TextureFormat textureFormat, bool mipChain, bool linear)
        : this(width, height, textureFormat, mipChain ? -1 : 1, linear)
    {
    }

    public Texture2D(int width, int height, TextureFormat textureFormat, bool mipChain, bool linear, bool createUninitialized)
        : this(width, height, textureFormat, mipChain, linear)
    {
        Uninitialize(createUninitialized);
    }

    public Texture2D(int width, int height, TextureFormat textureFormat, int mipCount, bool linear)
        : this(width, height, TextureFormats.Of(textureFormat, linear), textureFormat, mipCount)
    {
    }

    public Texture2D(int width, int height, GraphicsFormat format, TextureCreationFlags flags)
        : this(width, height, format, TextureFormats.ToTextureFormat(format), (flags & TextureCreationFlags.MipChain) != 0 ? -1 : 1)
    {
        Uninitialize((flags & TextureCreationFlags.DontInitializePixels) != 0);
    }

    public Texture2D(int width, int height, GraphicsFormat format, int mipCount, TextureCreationFlags flags)
        : this(width, height, format, TextureFormats.ToTextureFormat(format), mipCount)
    {
        Uninitialize((flags & TextureCreationFlags.DontInitializePixels) != 0);
    }

    public Texture2D(int width, int height, DefaultFormat format, TextureCreationFlags flags)
        : this(width, height, SystemInfo.GetGraphicsFormat(format), flags)
    {
    }

    private Texture2D(int width, int height, GraphicsFormat format, TextureFormat layout, int mipCount) =>
        store = NewStore(width, height, format, layout, mipCount);

    public static Texture2D whiteTexture => DefaultTextures.White;
    public static Texture2D blackTexture => DefaultTextures.Black;
    public static Texture2D redTexture => DefaultTextures.Red;
    public static Texture2D grayTexture => DefaultTextures.Gray;
    public static Texture2D linearGrayTexture => DefaultTextures.LinearGray;
    public static Texture2D normalTexture => DefaultTextures.Normal;

    public TextureFormat format => store.Layout;
    public override GraphicsFormat graphicsFormat => store.Format;
    public override bool isReadable => readable;

    internal override (int Width, int Height) Size => (store.Width, store.Height);
    internal override int MipLevels => store.MipLevels;

    public void Apply() => Apply(true, false);

    public void Apply(bool updateMipmaps) => Apply(updateMipmaps, false);

    public void Apply(bool updateMipmaps, bool makeNoLongerReadable)
    {
        RequireReadable();
        if (updateMipmaps)
        {
            store.BuildMips();
        }

        dirty = true;
        if (makeNoLongerReadable)
        {
            readable = false;
        }

        IncrementUpdateCount();
    }

    public bool Reinitialize(int width, int height) => Reinitialize(width, height, format, mipmapCount > 1);

    public bool Reinitialize(int width, int height, TextureFormat format, bool hasMipMap)
    {
        RequireReadable();
        store = NewStore(width, height, TextureFormats.Of(format, !isDataSRGB), format, hasMipMap ? -1 : 1);
        TextureMemory.Release(device);
        device = null;
        dirty = true;
        return true;
    }

    internal PixelStore Pixels
    {
        get
        {
            RequireReadable();
            return store;
        }
    }

    internal void MarkNonReadable() => readable = false;

    internal override GpuTexture? DeviceTexture(RenderTextureSubElement element)
    {
        device ??= TextureMemory.Create(
            new GpuTextureDescription
            {
                Width = store.Width,
                Height = store.Height,
                MipLevels = store.MipLevels,
                Format = TextureFormats.Device(store.Format),
                Usage = TextureUse.Sampled,
            },
            name);
        if (dirty)
        {
            dirty = false;
            store.Upload(device);
        }

        return device;
    }

    internal override void ReleaseNative()
    {
        TextureMemory.Release(device);
        device = null;
    }

    internal override Object CloneNative()
    {
        var copy = new Texture2D(store.Width, store.Height, store.Format, store.Layout, store.MipLevels)
        {
            name = name,
            filterMode = filterMode,
            wrapMode = wrapMode,
            anisoLevel = anisoLevel,
        };
        store.Data.CopyTo(copy.store.Data, 0);
        copy.readable = readable;
        return copy;
    }

    private static PixelStore NewStore(int width, int height, GraphicsFormat format, TextureFormat layout, int mipCount)
    {
        int limit = SystemInfo.maxTextureSize;
        if (width <= 0 || height <= 0 || width > limit || height > limit)
        {
            throw new UnityException($"Failed to create 2D texture of size {width}x{height}: each side must be between 1 and {limit}.");
        }

        if (TextureFormats.Device(format) == GpuFormat.None)
        {
            throw new NotSupportedException($"Graphics format {format} is not supported on this device.");
        }

        int chain = PixelStore.FullChain(width, height);
        var store = new PixelStore(width, height, 1, format, layout, mipCount <= 0 ? chain : Math.Min(mipCount, chain));
        store.Fill(new Color(0.804f, 0.804f, 0.804f, 0.804f));
        return store;
    }

    /// <summary>On a device that poisons, pixels that were not asked for hold set bits.</summary>
    private void Uninitialize(bool requested)
    {
        if (requested && MemoryPoison.Enabled)
        {
            store.Data.AsSpan().Fill(0xFF);
        }
    }

    private void RequireReadable()
    {
        if (!readable)
        {
            throw new ArgumentException(
                $"Texture '{name}' is not readable, the texture memory can not be accessed from scripts. You can make the texture readable in the Texture Import Settings.");
        }
    }
}
