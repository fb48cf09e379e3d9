using Headless.Shaders;
using Headless.Vulkan;

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

    public BlendState ToBlendState() => new()
    {
        SourceColor = Blend ? (GpuBlend)SourceColor : GpuBlend.One,
        TargetColor = Blend ? (GpuBlend)DestinationColor : GpuBlend.Zero,
        ColorOperation = Blend ? (GpuBlendOperation)OpColor : GpuBlendOperation.Add,
        SourceAlpha = Blend ? (GpuBlend)SourceAlpha : GpuBlend.One,
        TargetAlpha = Blend ? (GpuBlend)DestinationAlpha : GpuBlend.Zero,
        AlphaOperation = Blend ? (GpuBlendOperation)OpAlpha : GpuBlendOperation.Add,
        WriteMask = WriteMask(),
    };

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
