using System;
using Headless.Engine;
using Headless.Vulkan;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace UnityEngine;

public partial class RenderTexture : Texture
{
    private RenderTextureDescriptor description;
    private GpuTexture? color;
    private GpuTexture? multisampled;
    private GpuTexture? depthTexture;

    public RenderTexture(int width, int height, int depth)
        : this(width, height, depth, RenderTextureFormat.Default, RenderTextureReadWrite.Default)
    {
    }

    public RenderTexture(int width, int height, int depth, RenderTextureFormat format)
        : this(width, height, depth, format, RenderTextureReadWrite.Default)
    {
    }

    public RenderTexture(int width, int height, int depth, RenderTextureFormat format, int mipCount)
        : this(width, height, depth, format, RenderTextureReadWrite.Default)
    {
        description.mipCount = mipCount;
        description.useMipMap = mipCount > 1;
    }

    public RenderTexture(int width, int height, int depth, RenderTextureFormat format, RenderTextureReadWrite readWrite)
        : this(new RenderTextureDescriptor(width, height, format, depth) { graphicsFormat = TextureFormats.Of(format, readWrite) })
    {
    }

    public RenderTexture(int width, int height, int depth, GraphicsFormat format)
        : this(new RenderTextureDescriptor(width, height, format, depth))
    {
    }

    public RenderTexture(int width, int height, int depth, GraphicsFormat format, int mipCount)
        : this(new RenderTextureDescriptor(width, height, format, depth, mipCount) { useMipMap = mipCount > 1 })
    {
    }

    public RenderTexture(int width, int height, int depth, DefaultFormat format)
        : this(width, height, depth, SystemInfo.GetGraphicsFormat(format))
    {
    }

    public RenderTexture(RenderTexture textureToCopy)
        : this(textureToCopy.descriptor)
    {
    }

    public RenderTexture(RenderTextureDescriptor desc)
    {
        RenderTextureRules.Check(desc);
        description = desc;
        wrapMode = TextureWrapMode.Clamp;
    }

    public static RenderTexture? active { get; set; }

    public RenderTextureDescriptor descriptor
    {
        get => description;
        set
        {
            RequireReleased("descriptor");
            RenderTextureRules.Check(value);
            description = value;
        }
    }

    public RenderBuffer colorBuffer => new(this, false);
    public RenderBuffer depthBuffer => new(this, true);
    public override GraphicsFormat graphicsFormat => description.graphicsFormat;
    public bool sRGB => description.sRGB;

    internal override (int Width, int Height) Size => (description.width, description.height);

    internal override int MipLevels => !description.useMipMap
        ? 1
        : description.mipCount > 1 ? description.mipCount : PixelStore.FullChain(description.width, description.height, Depth3D);

    internal bool IsDepthOnly => description.graphicsFormat == GraphicsFormat.None;
    private int Depth3D => description.dimension == TextureDimension.Tex3D ? description.volumeDepth : 1;

    /// <summary>What drawing goes to: the multisampled texture where there is one.</summary>
    internal GpuTexture? DrawTarget => Created() ? multisampled ?? color : null;

    /// <summary>What the multisampled texture resolves into; null without multisampling.</summary>
    internal GpuTexture? ResolveTarget => multisampled is null ? null : color;

    internal GpuTexture? DepthTarget => Created() ? depthTexture : null;

    public bool Create()
    {
        if (IsCreated())
        {
            return true;
        }

        RenderTextureRules.Check(description);
        int samples = Math.Min(description.msaaSamples, SystemInfo.MaxSamples);
        if (!IsDepthOnly)
        {
            color = Make(TextureFormats.Device(description.graphicsFormat), 1, MipLevels, description.enableRandomWrite, name);
            multisampled = samples > 1 ? Make(TextureFormats.Device(description.graphicsFormat), samples, 1, false, name + " MSAA") : null;
        }

        if (description.depthBufferBits > 0)
        {
            depthTexture = Make(GpuFormat.D32Float, samples, 1, false, name + " depth");
        }

        return true;
    }

    public bool IsCreated() => color is not null || depthTexture is not null;

    public void Release()
    {
        TextureMemory.Release(color);
        TextureMemory.Release(multisampled);
        TextureMemory.Release(depthTexture);
        (color, multisampled, depthTexture) = (null, null, null);
    }

    public void DiscardContents() => DiscardContents(true, true);

    public void DiscardContents(bool discardColor, bool discardDepth)
    {
        if (discardColor)
        {
            Poison(color);
            Poison(multisampled);
        }

        if (discardDepth)
        {
            Poison(depthTexture);
        }
    }

    public void GenerateMips()
    {
        if (Created() && color is not null && color.Description.MipLevels > 1)
        {
            GraphicsDevice.Recorder.GenerateMips(color);
        }
    }

    public void ResolveAntiAliasedSurface()
    {
    }

    public void SetGlobalShaderProperty(string propertyName) => Shader.SetGlobalTexture(propertyName, this);

    internal override GpuTexture? DeviceTexture(RenderTextureSubElement element)
    {
        Create();
        return element == RenderTextureSubElement.Depth || IsDepthOnly ? depthTexture : color;
    }

    internal override void ReleaseNative() => Release();

    internal override Object CloneNative() => new RenderTexture(description) { name = name };

    private bool Created() => Create();

    private static void Poison(GpuTexture? texture)
    {
        if (texture is not null)
        {
            GraphicsDevice.Device.Poison(texture);
        }
    }

    private GpuTexture Make(GpuFormat format, int samples, int mips, bool storage, string label)
    {
        GpuTextureDimension shape = description.dimension switch
        {
            TextureDimension.Tex3D => GpuTextureDimension.Texture3D,
            TextureDimension.Tex2DArray => GpuTextureDimension.Texture2DArray,
            TextureDimension.Cube => GpuTextureDimension.Cube,
            _ => GpuTextureDimension.Texture2D,
        };

        // A storage view of an sRGB image is not allowed, in Vulkan as in D3D11: random writes see the plain bytes.
        GpuFormat actual = storage && format == GpuFormat.R8G8B8A8Srgb ? GpuFormat.R8G8B8A8Unorm : format;
        return TextureMemory.Create(
            new GpuTextureDescription
            {
                Width = description.width,
                Height = description.height,
                Depth = Depth3D,
                Layers = shape switch
                {
                    GpuTextureDimension.Cube => 6,
                    GpuTextureDimension.Texture2DArray => description.volumeDepth,
                    _ => 1,
                },
                MipLevels = mips,
                Format = actual,
                Samples = samples,
                Dimension = shape,
                Usage = (samples > 1 ? 0 : TextureUse.Sampled) | TextureUse.RenderTarget | (storage ? TextureUse.Storage : 0),
            },
            label);
    }

    private void RequireReleased(string what)
    {
        if (IsCreated())
        {
            throw new InvalidOperationException($"Setting {what} of already created render texture '{name}' is not supported: call Release first.");
        }
    }
}
