using System;
using Headless.Engine;
using Headless.Vulkan;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace UnityEngine;

/// <summary>Six square faces, each with its first row at the top as seen from inside, in Direct3D's order and directions.</summary>
public sealed class Cubemap : Texture
{
    private const int Faces = 6;
    private readonly PixelStore[] stores = new PixelStore[Faces];
    private GpuTexture? device;
    private bool dirty = true;
    private bool readable = true;

    public Cubemap(int width, TextureFormat textureFormat, bool mipChain)
        : this(width, TextureFormats.Of(textureFormat, false), textureFormat, mipChain ? -1 : 1)
    {
    }

    public Cubemap(int width, TextureFormat format, int mipCount)
        : this(width, TextureFormats.Of(format, false), format, mipCount)
    {
    }

    public Cubemap(int width, GraphicsFormat format, TextureCreationFlags flags)
        : this(width, format, TextureFormats.ToTextureFormat(format), (flags & TextureCreationFlags.MipChain) != 0 ? -1 : 1)
    {
    }

    private Cubemap(int width, GraphicsFormat format, TextureFormat layout, int mipCount)
    {
        if (width <= 0 || width > SystemInfo.maxCubemapSize)
        {
            throw new UnityException($"Failed to create cubemap of width {width}: it must be between 1 and {SystemInfo.maxCubemapSize}.");
        }

        int chain = PixelStore.FullChain(width, width);
        for (int face = 0; face < Faces; face++)
        {
            stores[face] = new PixelStore(width, width, 1, format, layout, mipCount <= 0 ? chain : Math.Min(mipCount, chain));
        }

        wrapMode = TextureWrapMode.Clamp;
    }

    public TextureFormat format => stores[0].Layout;
    public override TextureDimension dimension => TextureDimension.Cube;
    public override GraphicsFormat graphicsFormat => stores[0].Format;
    public override bool isReadable => readable;

    internal override (int Width, int Height) Size => (stores[0].Width, stores[0].Height);
    internal override int MipLevels => stores[0].MipLevels;

    public Color GetPixel(CubemapFace face, int x, int y) => GetPixel(face, x, y, 0);

    public Color GetPixel(CubemapFace face, int x, int y, int mip) => Face(face).Get(x, y, 0, mip);

    public void SetPixel(CubemapFace face, int x, int y, Color color) => SetPixel(face, x, y, color, 0);

    public void SetPixel(CubemapFace face, int x, int y, Color color, int mip) => Face(face).Set(x, y, 0, mip, color);

    public Color[] GetPixels(CubemapFace face) => GetPixels(face, 0);

    public Color[] GetPixels(CubemapFace face, int miplevel)
    {
        PixelStore store = Face(face);
        (int w, int h, _) = store.Extent(miplevel);
        var colors = new Color[w * h];
        for (int i = 0; i < colors.Length; i++)
        {
            colors[i] = store.Get(i % w, i / w, 0, miplevel);
        }

        return colors;
    }

    public void SetPixels(Color[] colors, CubemapFace face) => SetPixels(colors, face, 0);

    public void SetPixels(Color[] colors, CubemapFace face, int miplevel)
    {
        ArgumentNullException.ThrowIfNull(colors);
        PixelStore store = Face(face);
        (int w, int h, _) = store.Extent(miplevel);
        if (colors.Length < w * h)
        {
            throw new ArgumentException($"Array of {colors.Length} colors is too short for a face of cubemap '{name}' of {w}x{h} texels.");
        }

        for (int i = 0; i < w * h; i++)
        {
            store.Set(i % w, i / w, 0, miplevel, colors[i]);
        }
    }

    public void Apply() => Apply(true, false);

    public void Apply(bool updateMipmaps) => Apply(updateMipmaps, false);

    public void Apply(bool updateMipmaps, bool makeNoLongerReadable)
    {
        foreach (PixelStore store in stores)
        {
            if (updateMipmaps)
            {
                store.BuildMips();
            }
        }

        dirty = true;
        readable &= !makeNoLongerReadable;
    }

    internal override GpuTexture? DeviceTexture(RenderTextureSubElement element)
    {
        device ??= TextureMemory.Create(
            new GpuTextureDescription
            {
                Width = stores[0].Width,
                Height = stores[0].Height,
                MipLevels = MipLevels,
                Layers = Faces,
                Format = TextureFormats.Device(graphicsFormat),
                Dimension = GpuTextureDimension.Cube,
            },
            name);
        if (dirty)
        {
            dirty = false;
            for (int face = 0; face < Faces; face++)
            {
                stores[face].Upload(device, face);
            }
        }

        return device;
    }

    internal override void ReleaseNative() => TextureMemory.Release(device);

    private PixelStore Face(CubemapFace face) => face is >= CubemapFace.PositiveX and <= CubemapFace.NegativeZ
        ? stores[(int)face]
        : throw new ArgumentException($"Cubemap '{name}' has no face {face}.", nameof(face));
}
