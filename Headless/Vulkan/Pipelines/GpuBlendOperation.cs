namespace Headless.Vulkan;

/// <summary>How weighted source and target are joined.</summary>
public enum GpuBlendOperation
{
    /// <summary>Source + target.</summary>
    Add,

    /// <summary>Source - target.</summary>
    Subtract,

    /// <summary>Target - source.</summary>
    ReverseSubtract,

    /// <summary>Smaller of both.</summary>
    Min,

    /// <summary>Larger of both.</summary>
    Max,
}
