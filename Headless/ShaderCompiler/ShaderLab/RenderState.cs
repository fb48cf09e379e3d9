namespace Headless.Shaders;

/// <summary>Render state of a pass: commands of the pass over those of its SubShader over Unity's defaults.</summary>
/// <remarks>
/// Numbers are those of UnityEngine.Rendering: CullMode (Off 0, Front 1, Back 2), CompareFunction (Disabled 0, Never 1, Less 2,
/// Equal 3, LessEqual 4, Greater 5, NotEqual 6, GreaterEqual 7, Always 8), BlendMode (Zero 0, One 1, DstColor 2, SrcColor 3,
/// OneMinusDstColor 4, SrcAlpha 5, OneMinusSrcColor 6, DstAlpha 7, OneMinusDstAlpha 8, SrcAlphaSaturate 9,
/// OneMinusSrcAlpha 10), BlendOp (Add 0, Subtract 1, ReverseSubtract 2, Min 3, Max 4),
/// ColorWriteMask (Alpha 1, Blue 2, Green 4, Red 8). ZTest and ZWrite are as written: with reversed Z the device compares
/// vice versa.
/// </remarks>
public sealed record RenderState
{
    public RenderStateValue Cull { get; init; } = 2;
    public RenderStateValue ZWrite { get; init; } = 1;
    public RenderStateValue ZTest { get; init; } = 4;
    public RenderStateValue ZClip { get; init; } = 1;
    public RenderStateValue AlphaToMask { get; init; } = 0;
    public RenderStateValue ColorMask { get; init; } = 15;
    public RenderStateValue OffsetFactor { get; init; } = 0;
    public RenderStateValue OffsetUnits { get; init; } = 0;

    /// <summary>False without a Blend command or after "Blend Off".</summary>
    public bool Blend { get; init; }
    public RenderStateValue SourceColor { get; init; } = 1;
    public RenderStateValue DestinationColor { get; init; } = 0;
    public RenderStateValue SourceAlpha { get; init; } = 1;
    public RenderStateValue DestinationAlpha { get; init; } = 0;
    public RenderStateValue BlendOpColor { get; init; } = 0;
    public RenderStateValue BlendOpAlpha { get; init; } = 0;
}
