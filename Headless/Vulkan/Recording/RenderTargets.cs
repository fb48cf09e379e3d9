namespace Headless.Vulkan;

/// <summary>The targets of a run of draws.</summary>
public sealed record RenderTargets
{
    /// <summary>Color targets in order; may be empty with a depth target.</summary>
    public IReadOnlyList<ColorTarget> Colors { get; init; } = [];

    /// <summary>Depth target or null.</summary>
    public DepthTarget? Depth { get; init; }

    /// <summary>Viewport; null covers the targets.</summary>
    public GpuViewport? Viewport { get; init; }
}
