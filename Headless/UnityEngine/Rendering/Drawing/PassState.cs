using Headless.Shaders;
using Headless.Vulkan;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>The render state of a pass with the material's numbers filled in.</summary>
internal readonly record struct PassState(
    int Cull, bool ZWrite, int ZTest, bool ZClip, bool AlphaToMask, int ColorMask, float OffsetFactor, float OffsetUnits,
    bool Blend, int SourceColor, int DestinationColor, int SourceAlpha, int DestinationAlpha, int OpColor, int OpAlpha)
{
    public static PassState Of(RenderState state, in PropertyChain chain) => new(
        Number(state.Cull, chain),
        Number(state.ZWrite, chain) != 0,
        Number(state.ZTest, chain),
        Number(state.ZClip, chain) != 0,
        Number(state.AlphaToMask, chain) != 0,
        Number(state.ColorMask, chain),
        Value(state.OffsetFactor, chain),
        Value(state.OffsetUnits, chain),
        state.Blend,
        Number(state.SourceColor, chain),
        Number(state.DestinationColor, chain),
        Number(state.SourceAlpha, chain),
        Number(state.DestinationAlpha, chain),
        Number(state.BlendOpColor, chain),
        Number(state.BlendOpAlpha, chain));

    /// <summary>What a renderer list sets in the pass's place.</summary>
    public PassState With(in RenderStateBlock? overrides)
    {
        if (overrides is not { } block)
        {
            return this;
        }

        PassState state = this;
        if ((block.mask & RenderStateMask.Raster) != 0)
        {
            RasterState raster = block.rasterState;
            state = state with
            {
                Cull = (int)raster.cullingMode,
                ZClip = raster.depthClip,
                OffsetFactor = raster.offsetFactor,
                OffsetUnits = raster.offsetUnits,
            };
        }

        if ((block.mask & RenderStateMask.Depth) != 0)
        {
            state = state with { ZWrite = block.depthState.writeEnabled, ZTest = (int)block.depthState.compareFunction };
        }

        return (block.mask & RenderStateMask.Blend) != 0 ? state.With(block.blendState) : state;
    }

    public PassState Offset((float Units, float Slope) bias) =>
        this with { OffsetUnits = OffsetUnits + bias.Units, OffsetFactor = OffsetFactor + bias.Slope };

    /// <summary>Depth is reversed on this device: near is 1, so every comparison turns round.</summary>
    public GpuCompare DepthCompare => ZTest switch
    {
        1 => GpuCompare.Never,
        2 => GpuCompare.Greater,
        3 => GpuCompare.Equal,
        4 => GpuCompare.GreaterEqual,
        5 => GpuCompare.Less,
        6 => GpuCompare.NotEqual,
        7 => GpuCompare.LessEqual,
        _ => GpuCompare.Always,
    };

    public Headless.Vulkan.BlendState ToBlendState() => new()
    {
        SourceColor = Blend ? (GpuBlend)SourceColor : GpuBlend.One,
        TargetColor = Blend ? (GpuBlend)DestinationColor : GpuBlend.Zero,
        ColorOperation = Blend ? (GpuBlendOperation)OpColor : GpuBlendOperation.Add,
        SourceAlpha = Blend ? (GpuBlend)SourceAlpha : GpuBlend.One,
        TargetAlpha = Blend ? (GpuBlend)DestinationAlpha : GpuBlend.Zero,
        AlphaOperation = Blend ? (GpuBlendOperation)OpAlpha : GpuBlendOperation.Add,
        WriteMask = WriteMask(),
    };

    // Blending by One and Zero is none.
    private PassState With(in UnityEngine.Rendering.BlendState blending)
    {
        RenderTargetBlendState first = blending.blendState0;
        return this with
        {
            Blend = true,
            AlphaToMask = blending.alphaToMask,
            ColorMask = (int)first.writeMask,
            SourceColor = (int)first.sourceColorBlendMode,
            DestinationColor = (int)first.destinationColorBlendMode,
            SourceAlpha = (int)first.sourceAlphaBlendMode,
            DestinationAlpha = (int)first.destinationAlphaBlendMode,
            OpColor = (int)first.colorBlendOperation,
            OpAlpha = (int)first.alphaBlendOperation,
        };
    }

    // ShaderLab counts the channels from alpha up, the device from red.
    private GpuColorMask WriteMask()
    {
        GpuColorMask mask = 0;
        mask |= (ColorMask & 8) != 0 ? GpuColorMask.Red : 0;
        mask |= (ColorMask & 4) != 0 ? GpuColorMask.Green : 0;
        mask |= (ColorMask & 2) != 0 ? GpuColorMask.Blue : 0;
        mask |= (ColorMask & 1) != 0 ? GpuColorMask.Alpha : 0;
        return mask;
    }

    private static int Number(RenderStateValue value, in PropertyChain chain) => (int)Value(value, chain);

    private static float Value(RenderStateValue value, in PropertyChain chain) =>
        value.Property is { } name && chain.Value(ShaderNames.Id(name)) is { } set ? set.X : value.Value;
}
