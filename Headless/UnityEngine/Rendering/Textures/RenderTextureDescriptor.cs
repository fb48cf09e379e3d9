using Headless.Engine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace UnityEngine;

public struct RenderTextureDescriptor
{
    private int depthBits;

    public RenderTextureDescriptor(int width, int height)
        : this(width, height, RenderTextureFormat.Default, 0)
    {
    }

    public RenderTextureDescriptor(int width, int height, RenderTextureFormat colorFormat)
        : this(width, height, colorFormat, 0)
    {
    }

    public RenderTextureDescriptor(int width, int height, RenderTextureFormat colorFormat, int depthBufferBits)
        : this(width, height, TextureFormats.Of(colorFormat, RenderTextureReadWrite.Default), depthBufferBits)
    {
        if (colorFormat is RenderTextureFormat.Depth or RenderTextureFormat.Shadowmap)
        {
            depthBits = depthBufferBits == 0 ? 32 : depthBufferBits;
        }
    }

    public RenderTextureDescriptor(int width, int height, GraphicsFormat colorFormat, int depthBufferBits)
        : this(width, height, colorFormat, depthBufferBits, 1)
    {
    }

    public RenderTextureDescriptor(int width, int height, GraphicsFormat colorFormat, int depthBufferBits, int mipCount)
    {
        depthBits = depthBufferBits;
        this.width = width;
        this.height = height;
        graphicsFormat = colorFormat;
        this.mipCount = mipCount;
        volumeDepth = 1;
        msaaSamples = 1;
        dimension = TextureDimension.Tex2D;
        autoGenerateMips = true;
    }

    public RenderTextureDescriptor(int width, int height, GraphicsFormat colorFormat, GraphicsFormat depthStencilFormat)
        : this(width, height, colorFormat, 0)
    {
        this.depthStencilFormat = depthStencilFormat;
    }

    public int width { get; set; }
    public int height { get; set; }
    public int msaaSamples { get; set; }
    public int volumeDepth { get; set; }
    public int mipCount { get; set; }
    public GraphicsFormat graphicsFormat { get; set; }
    public TextureDimension dimension { get; set; }
    public ShadowSamplingMode shadowSamplingMode { get; set; }
    public VRTextureUsage vrUsage { get; set; }
    public RenderTextureMemoryless memoryless { get; set; }
    public bool enableRandomWrite { get; set; }
    public bool useMipMap { get; set; }
    public bool autoGenerateMips { get; set; }
    public bool bindMS { get; set; }
    public bool useDynamicScale { get; set; }

    public int depthBufferBits
    {
        get => depthBits;
        set => depthBits = value;
    }

    public GraphicsFormat depthStencilFormat
    {
        get => depthBits > 0 ? GraphicsFormat.D32_SFloat : GraphicsFormat.None;
        set => depthBits = value == GraphicsFormat.None ? 0 : 32;
    }

    public RenderTextureFormat colorFormat
    {
        get => TextureFormats.ToRenderTextureFormat(graphicsFormat);
        set => graphicsFormat = TextureFormats.Of(value, sRGB ? RenderTextureReadWrite.sRGB : RenderTextureReadWrite.Linear);
    }

    public bool sRGB
    {
        get => TextureFormats.IsSrgb(graphicsFormat);
        set => graphicsFormat = TextureFormats.WithSrgb(graphicsFormat, value);
    }
}
