using UnityEngine.Experimental.Rendering;

namespace UnityEngine.Rendering.RenderGraphModule;

public struct TextureDesc
{
    public TextureSizeMode sizeMode;
    public int width;
    public int height;
    public int slices;
    public GraphicsFormat format;
    public FilterMode filterMode;
    public TextureWrapMode wrapMode;
    public TextureDimension dimension;
    public bool enableRandomWrite;
    public bool useMipMap;
    public bool autoGenerateMips;
    public bool isShadowMap;
    public int anisoLevel;
    public float mipMapBias;
    public MSAASamples msaaSamples;
    public bool bindTextureMS;
    public bool clearBuffer;
    public Color clearColor;
    public bool discardBuffer;
    public VRTextureUsage vrUsage;
    public string name;

    public TextureDesc(int width, int height, bool dynamicResolution = false, bool xrReady = false)
        : this()
    {
        (sizeMode, this.width, this.height, slices) = (TextureSizeMode.Explicit, width, height, 1);
        (dimension, msaaSamples, wrapMode, filterMode, name) = (TextureDimension.Tex2D, MSAASamples.None, TextureWrapMode.Clamp, FilterMode.Point, string.Empty);
    }

    public TextureDesc(RenderTextureDescriptor input)
        : this(input.width, input.height)
    {
        (slices, dimension, msaaSamples, bindTextureMS) = (input.volumeDepth, input.dimension, (MSAASamples)input.msaaSamples, input.bindMS);
        (enableRandomWrite, useMipMap, autoGenerateMips, vrUsage) = (input.enableRandomWrite, input.useMipMap, input.autoGenerateMips, input.vrUsage);
        isShadowMap = input.shadowSamplingMode != ShadowSamplingMode.None && input.depthStencilFormat != GraphicsFormat.None;
        format = input.depthStencilFormat != GraphicsFormat.None ? input.depthStencilFormat : input.graphicsFormat;
    }

    public TextureDesc(RenderTexture input)
        : this(input.descriptor)
    {
        (filterMode, wrapMode, name) = (input.filterMode, input.wrapMode, input.name);
    }

    public TextureDesc(TextureDesc input) => this = input;

    public GraphicsFormat colorFormat
    {
        readonly get => IsDepth ? GraphicsFormat.None : format;
        set => format = value;
    }

    public DepthBits depthBufferBits
    {
        readonly get => IsDepth ? DepthBits.Depth32 : DepthBits.None;
        set
        {
            if (value != DepthBits.None)
            {
                format = GraphicsFormat.D32_SFloat;
            }
            else if (IsDepth)
            {
                format = GraphicsFormat.None;
            }
        }
    }

    internal readonly bool IsDepth => format is GraphicsFormat.D16_UNorm or GraphicsFormat.D24_UNorm or GraphicsFormat.D24_UNorm_S8_UInt
        or GraphicsFormat.D32_SFloat or GraphicsFormat.D32_SFloat_S8_UInt or GraphicsFormat.S8_UInt;

    public readonly Vector2Int CalculateFinalDimensions() => new(width, height);

    internal readonly RenderTextureDescriptor ToDescriptor() => new(width, height, IsDepth ? GraphicsFormat.None : format, IsDepth ? format : GraphicsFormat.None)
    {
        volumeDepth = slices,
        dimension = dimension,
        msaaSamples = (int)msaaSamples,
        bindMS = bindTextureMS,
        enableRandomWrite = enableRandomWrite,
        useMipMap = useMipMap,
        autoGenerateMips = autoGenerateMips,
        vrUsage = vrUsage,
        shadowSamplingMode = isShadowMap ? ShadowSamplingMode.CompareDepths : ShadowSamplingMode.None,
    };
}
