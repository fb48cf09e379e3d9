using System.Linq;
using System;
using Headless.Engine;
using Headless.Vulkan;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed class Texture3D : Texture
{
    private readonly PixelStore store;
    private GpuTexture? device;
    private bool dirty = true;
    private bool readable = true;

    public Texture3D(int width, int height, int depth, TextureFormat textureFormat, bool mipChain)
        : this(width, height, depth, TextureFormats.Of(textureFormat, true), textureFormat, mipChain ? -1 : 1)
    {
    }

    public Texture3D(int width, int height, int depth, TextureFormat textureFormat, int mipCount)
        : this(width, height, depth, TextureFormats.Of(textureFormat, true), textureFormat, mipCount)
    {
    }

    public Texture3D(int width, int height, int depth, GraphicsFormat format, TextureCreationFlags flags)
        : this(width, height, depth, format, TextureFormats.ToTextureFormat(format), (flags & TextureCreationFlags.MipChain) != 0 ? -1 : 1)
    {
    }

    private Texture3D(int width, int height, int depth, GraphicsFormat format, TextureFormat layout, int mipCount)
    {
        int limit = SystemInfo.maxTexture3DSize;
        if (Math.Min(width, Math.Min(height, depth)) <= 0 || Math.Max(width, Math.Max(height, depth)) > limit)
        {
            throw new UnityException($"Failed to create 3D texture of size {width}x{height}x{depth}: each side must be between 1 and {limit}.");
        }

        int chain = PixelStore.FullChain(width, height, depth);
        store = new PixelStore(width, height, depth, format, layout, mipCount <= 0 ? chain : Math.Min(mipCount, chain));
    }

    public int depth => store.Depth;
    public TextureFormat format => store.Layout;
    public override TextureDimension dimension => TextureDimension.Tex3D;
    public override GraphicsFormat graphicsFormat => store.Format;
    public override bool isReadable => readable;

    internal override (int Width, int Height) Size => (store.Width, store.Height);
    internal override int MipLevels => store.MipLevels;

    public Color GetPixel(int x, int y, int z) => GetPixel(x, y, z, 0);

    public Color GetPixel(int x, int y, int z, int mipLevel) => store.Get(x, y, z, mipLevel);

    public void SetPixel(int x, int y, int z, Color color) => SetPixel(x, y, z, color, 0);

    public void SetPixel(int x, int y, int z, Color color, int mipLevel) => store.Set(x, y, z, mipLevel, color);

    public Color[] GetPixels() => GetPixels(0);

    public Color[] GetPixels(int miplevel)
    {
        (int w, int h, int d) = store.Extent(miplevel);
        var colors = new Color[w * h * d];
        for (int i = 0; i < colors.Length; i++)
        {
            colors[i] = store.Get(i % w, i / w % h, i / (w * h), miplevel);
        }

        return colors;
    }

    public void SetPixels(Color[] colors) => SetPixels(colors, 0);

    public void SetPixels(Color[] colors, int miplevel)
    {
        ArgumentNullException.ThrowIfNull(colors);
        (int w, int h, int d) = store.Extent(miplevel);
        if (colors.Length < w * h * d)
        {
            throw new ArgumentException($"Array of {colors.Length} colors is too short for texture '{name}' of {w}x{h}x{d} texels.");
        }

        for (int i = 0; i < w * h * d; i++)
        {
            store.Set(i % w, i / w % h, i / (w * h), miplevel, colors[i]);
        }
    }

    public void SetPixelData<T>(T[] data, int mipLevel, int sourceDataStartIndex = 0)
    {
        ArgumentNullException.ThrowIfNull(data);
        ArrayBytes.RequireBlittable(data, "Texture3D.SetPixelData");
        Span<byte> source = ArrayBytes.Of(data, sourceDataStartIndex, data.Length - sourceDataStartIndex);
        Span<byte> target = store.Mip(mipLevel);
        if (source.Length < target.Length)
        {
            throw new UnityException($"SetPixelData: {source.Length} bytes are too few for mip level {mipLevel} of texture '{name}', which holds {target.Length}.");
        }

        source[..target.Length].CopyTo(target);
    }

    public void Apply() => Apply(true, false);

    public void Apply(bool updateMipmaps) => Apply(updateMipmaps, false);

    public void Apply(bool updateMipmaps, bool makeNoLongerReadable)
    {
        if (updateMipmaps)
        {
            store.BuildMips();
        }

        dirty = true;
        readable &= !makeNoLongerReadable;
    }

    internal override GpuTexture? DeviceTexture(RenderTextureSubElement element)
    {
        device ??= TextureMemory.Create(
            new GpuTextureDescription
            {
                Width = store.Width,
                Height = store.Height,
                Depth = store.Depth,
                MipLevels = store.MipLevels,
                Format = TextureFormats.Device(store.Format),
                Dimension = GpuTextureDimension.Texture3D,
            },
            name);
        if (dirty)
        {
            dirty = false;
            store.Upload(device);
        }

        return device;
    }

    internal override void ReleaseNative() => TextureMemory.Release(device);
}
