using System.Runtime.InteropServices;
using System;
using Headless.Engine;
using Unity.Collections;

namespace UnityEngine;

public sealed partial class Texture2D
{
    public Color GetPixel(int x, int y) => GetPixel(x, y, 0);

    public Color GetPixel(int x, int y, int mipLevel)
    {
        (int w, int h, _) = Pixels.Extent(mipLevel);
        return store.Get(Wrap(x, w, wrapModeU), Wrap(y, h, wrapModeV), 0, mipLevel);
    }

    public Color GetPixelBilinear(float u, float v) => GetPixelBilinear(u, v, 0);

    public Color GetPixelBilinear(float u, float v, int mipLevel)
    {
        (int w, int h, _) = Pixels.Extent(mipLevel);
        float x = (u * w) - 0.5f;
        float y = (v * h) - 0.5f;
        int x0 = Mathf.FloorToInt(x);
        int y0 = Mathf.FloorToInt(y);
        Color bottom = Color.LerpUnclamped(GetPixel(x0, y0, mipLevel), GetPixel(x0 + 1, y0, mipLevel), x - x0);
        Color top = Color.LerpUnclamped(GetPixel(x0, y0 + 1, mipLevel), GetPixel(x0 + 1, y0 + 1, mipLevel), x - x0);
        return Color.LerpUnclamped(bottom, top, y - y0);
    }

    public Color[] GetPixels() => GetPixels(0);

    public Color[] GetPixels(int miplevel)
    {
        (int w, int h, _) = Pixels.Extent(miplevel);
        return GetPixels(0, 0, w, h, miplevel);
    }

    public Color[] GetPixels(int x, int y, int blockWidth, int blockHeight) => GetPixels(x, y, blockWidth, blockHeight, 0);

    public Color[] GetPixels(int x, int y, int blockWidth, int blockHeight, int miplevel)
    {
        RequireBlock(x, y, blockWidth, blockHeight, miplevel);
        var colors = new Color[blockWidth * blockHeight];
        for (int i = 0; i < colors.Length; i++)
        {
            colors[i] = store.Get(x + (i % blockWidth), y + (i / blockWidth), 0, miplevel);
        }

        return colors;
    }

    public Color32[] GetPixels32() => GetPixels32(0);

    public Color32[] GetPixels32(int miplevel) => Array.ConvertAll(GetPixels(miplevel), c => (Color32)c);

    public void SetPixel(int x, int y, Color color) => SetPixel(x, y, color, 0);

    public void SetPixel(int x, int y, Color color, int mipLevel)
    {
        (int w, int h, _) = Pixels.Extent(mipLevel);
        store.Set(Wrap(x, w, wrapModeU), Wrap(y, h, wrapModeV), 0, mipLevel, color);
    }

    public void SetPixels(Color[] colors) => SetPixels(colors, 0);

    public void SetPixels(Color[] colors, int miplevel)
    {
        (int w, int h, _) = Pixels.Extent(miplevel);
        SetPixels(0, 0, w, h, colors, miplevel);
    }

    public void SetPixels(int x, int y, int blockWidth, int blockHeight, Color[] colors) =>
        SetPixels(x, y, blockWidth, blockHeight, colors, 0);

    public void SetPixels(int x, int y, int blockWidth, int blockHeight, Color[] colors, int miplevel)
    {
        ArgumentNullException.ThrowIfNull(colors);
        RequireBlock(x, y, blockWidth, blockHeight, miplevel);
        if (colors.Length < blockWidth * blockHeight)
        {
            throw new ArgumentException($"Array of {colors.Length} colors is too short for a block of {blockWidth}x{blockHeight} pixels of texture '{name}'.");
        }

        for (int i = 0; i < blockWidth * blockHeight; i++)
        {
            store.Set(x + (i % blockWidth), y + (i / blockWidth), 0, miplevel, colors[i]);
        }
    }

    public void SetPixels32(Color32[] colors) => SetPixels32(colors, 0);

    public void SetPixels32(Color32[] colors, int miplevel) => SetPixels(Array.ConvertAll(colors, c => (Color)c), miplevel);

    public void SetPixels32(int x, int y, int blockWidth, int blockHeight, Color32[] colors) =>
        SetPixels(x, y, blockWidth, blockHeight, Array.ConvertAll(colors, c => (Color)c), 0);

    public byte[] GetRawTextureData() => (byte[])Pixels.Data.Clone();

    public NativeArray<T> GetRawTextureData<T>()
        where T : struct => CopyOf<T>(Pixels.Data);

    public NativeArray<T> GetPixelData<T>(int mipLevel)
        where T : struct => CopyOf<T>(Pixels.Mip(mipLevel));

    public void SetPixelData<T>(T[] data, int mipLevel, int sourceDataStartIndex = 0)
    {
        ArgumentNullException.ThrowIfNull(data);
        ArrayBytes.RequireBlittable(data, "Texture2D.SetPixelData");
        LoadMip(ArrayBytes.Of(data, sourceDataStartIndex, data.Length - sourceDataStartIndex), mipLevel);
    }

    public void SetPixelData<T>(NativeArray<T> data, int mipLevel, int sourceDataStartIndex = 0)
        where T : struct => LoadMip(NativeSpans.Bytes(data)[(sourceDataStartIndex * NativeSpans.SizeOf<T>())..], mipLevel);

    public void LoadRawTextureData(byte[] data)
    {
        ArgumentNullException.ThrowIfNull(data);
        LoadRaw(data);
    }

    public void LoadRawTextureData<T>(NativeArray<T> data)
        where T : struct => LoadRaw(NativeSpans.Bytes(data));

    public void ReadPixels(Rect source, int destX, int destY) => ReadPixels(source, destX, destY, true);

    public void ReadPixels(Rect source, int destX, int destY, bool recalculateMipMaps)
    {
        TextureReader.ReadPixels(source, Pixels, destX, destY, name);
        if (recalculateMipMaps)
        {
            store.BuildMips();
        }
    }

    private static NativeArray<T> CopyOf<T>(ReadOnlySpan<byte> bytes)
        where T : struct
    {
        var copy = new NativeArray<T>(bytes.Length / NativeSpans.SizeOf<T>(), Allocator.Persistent);
        bytes.CopyTo(NativeSpans.WriteBytes(copy));
        return copy;
    }

    private static int Wrap(int i, int size, TextureWrapMode mode) => mode switch
    {
        TextureWrapMode.Repeat => ((i % size) + size) % size,
        _ => Math.Clamp(i, 0, size - 1),
    };

    private void LoadRaw(ReadOnlySpan<byte> data)
    {
        if (data.Length < Pixels.Data.Length)
        {
            throw new UnityException(
                $"LoadRawTextureData: not enough data provided (will result in overread): {data.Length} of {store.Data.Length} bytes for texture '{name}'.");
        }

        data[..store.Data.Length].CopyTo(store.Data);
    }

    private void LoadMip(ReadOnlySpan<byte> data, int mipLevel)
    {
        Span<byte> target = Pixels.Mip(mipLevel);
        if (data.Length < target.Length)
        {
            throw new UnityException($"SetPixelData: {data.Length} bytes are too few for mip level {mipLevel} of texture '{name}', which holds {target.Length}.");
        }

        data[..target.Length].CopyTo(target);
    }

    private void RequireBlock(int x, int y, int blockWidth, int blockHeight, int mip)
    {
        if (mip < 0 || mip >= Pixels.MipLevels)
        {
            throw new ArgumentException($"Mip level {mip} is out of bounds of texture '{name}', which has {store.MipLevels}.");
        }

        (int w, int h, _) = store.Extent(mip);
        if (x < 0 || y < 0 || blockWidth < 0 || blockHeight < 0 || x + blockWidth > w || y + blockHeight > h)
        {
            throw new ArgumentException($"Block of {blockWidth}x{blockHeight} at ({x}, {y}) is out of bounds of texture '{name}' of {w}x{h} pixels.");
        }
    }
}
