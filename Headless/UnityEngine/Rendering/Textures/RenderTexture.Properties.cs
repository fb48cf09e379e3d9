using Headless.Engine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace UnityEngine;

public partial class RenderTexture
{
    public override int width
    {
        get => description.width;
        set
        {
            RequireReleased("width");
            description.width = value;
        }
    }

    public override int height
    {
        get => description.height;
        set
        {
            RequireReleased("height");
            description.height = value;
        }
    }

    public override TextureDimension dimension
    {
        get => description.dimension;
        set
        {
            RequireReleased("dimension");
            description.dimension = value;
        }
    }

    public int depth
    {
        get => description.depthBufferBits;
        set
        {
            RequireReleased("depth");
            description.depthBufferBits = value;
        }
    }

    public GraphicsFormat depthStencilFormat
    {
        get => description.depthStencilFormat;
        set
        {
            RequireReleased("depthStencilFormat");
            description.depthStencilFormat = value;
        }
    }

    public RenderTextureFormat format
    {
        get => description.colorFormat;
        set
        {
            RequireReleased("format");
            description.colorFormat = value;
        }
    }

    public int volumeDepth
    {
        get => description.volumeDepth;
        set
        {
            RequireReleased("volumeDepth");
            description.volumeDepth = value;
        }
    }

    public int antiAliasing
    {
        get => description.msaaSamples;
        set
        {
            RequireReleased("antiAliasing");
            description.msaaSamples = value;
        }
    }

    public bool enableRandomWrite
    {
        get => description.enableRandomWrite;
        set
        {
            RequireReleased("enableRandomWrite");
            description.enableRandomWrite = value;
        }
    }

    public bool useMipMap
    {
        get => description.useMipMap;
        set
        {
            RequireReleased("useMipMap");
            description.useMipMap = value;
        }
    }

    public bool autoGenerateMips
    {
        get => description.autoGenerateMips;
        set => description.autoGenerateMips = value;
    }

    public bool bindTextureMS
    {
        get => description.bindMS;
        set => description.bindMS = value;
    }

    public static RenderTexture GetTemporary(RenderTextureDescriptor desc) => TemporaryTextures.Get(desc);

    public static RenderTexture GetTemporary(int width, int height) => GetTemporary(width, height, 0);

    public static RenderTexture GetTemporary(int width, int height, int depthBuffer) =>
        GetTemporary(width, height, depthBuffer, RenderTextureFormat.Default);

    public static RenderTexture GetTemporary(int width, int height, int depthBuffer, RenderTextureFormat format) =>
        GetTemporary(width, height, depthBuffer, format, RenderTextureReadWrite.Default);

    public static RenderTexture GetTemporary(int width, int height, int depthBuffer, RenderTextureFormat format, RenderTextureReadWrite readWrite) =>
        GetTemporary(width, height, depthBuffer, format, readWrite, 1);

    public static RenderTexture GetTemporary(
        int width, int height, int depthBuffer, RenderTextureFormat format, RenderTextureReadWrite readWrite, int antiAliasing) =>
        TemporaryTextures.Get(new RenderTextureDescriptor(width, height, format, depthBuffer)
        {
            graphicsFormat = TextureFormats.Of(format, readWrite),
            msaaSamples = antiAliasing,
        });

    public static RenderTexture GetTemporary(int width, int height, int depthBuffer, GraphicsFormat format) =>
        TemporaryTextures.Get(new RenderTextureDescriptor(width, height, format, depthBuffer));

    public static void ReleaseTemporary(RenderTexture temp) => TemporaryTextures.Release(temp);
}
