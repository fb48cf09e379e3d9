namespace Headless.Vulkan;

/// <summary>Blend factors.</summary>
public enum GpuBlend
{
    /// <summary>0.</summary>
    Zero,

    /// <summary>1.</summary>
    One,

    /// <summary>Target color.</summary>
    DstColor,

    /// <summary>Source color.</summary>
    SrcColor,

    /// <summary>1 - target color.</summary>
    OneMinusDstColor,

    /// <summary>Source alpha.</summary>
    SrcAlpha,

    /// <summary>1 - source color.</summary>
    OneMinusSrcColor,

    /// <summary>Target alpha.</summary>
    DstAlpha,

    /// <summary>1 - target alpha.</summary>
    OneMinusDstAlpha,

    /// <summary>min(source alpha, 1 - target alpha).</summary>
    SrcAlphaSaturate,

    /// <summary>1 - source alpha.</summary>
    OneMinusSrcAlpha,
}
