using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Something to be drawn by the cameras of this frame.</summary>
internal sealed class DrawRequest
{
    public required Material Material { get; init; }
    public required DrawGeometry Geometry { get; init; }
    public PropertySheet? Block { get; init; }
    public Matrix4x4 Matrix { get; init; } = Matrix4x4.identity;

    /// <summary>World space.</summary>
    public Bounds Bounds { get; init; }

    public int Layer { get; init; }
    public Camera? Camera { get; init; }
    public ShadowCastingMode Shadows { get; init; } = ShadowCastingMode.On;
    public bool ReceiveShadows { get; init; } = true;
    public ReflectionProbeUsage Reflections { get; init; } = ReflectionProbeUsage.BlendProbes;
    public uint RenderingLayers { get; init; } = 1u;
    public MotionVectorGenerationMode Motion { get; init; } = MotionVectorGenerationMode.Camera;

    /// <summary>In the sorting layer.</summary>
    public int SortingOrder { get; init; }

    public int SortingLayer { get; init; }
    public int Priority { get; init; }

    public bool CastsShadows => Shadows != ShadowCastingMode.Off;
    public bool IsVisible => Shadows != ShadowCastingMode.ShadowsOnly;

    public bool SeenBy(Camera? camera, int cullingMask) =>
        (Camera is null || ReferenceEquals(Camera, camera)) && (cullingMask & (1 << Layer)) != 0;
}
