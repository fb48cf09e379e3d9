namespace Headless.Vulkan;

/// <summary>Comparison against the stored value.</summary>
public enum GpuCompare
{
    /// <summary>Never passes.</summary>
    Never,

    /// <summary>New &lt; stored.</summary>
    Less,

    /// <summary>New = stored.</summary>
    Equal,

    /// <summary>New &lt;= stored.</summary>
    LessEqual,

    /// <summary>New &gt; stored.</summary>
    Greater,

    /// <summary>New != stored.</summary>
    NotEqual,

    /// <summary>New &gt;= stored.</summary>
    GreaterEqual,

    /// <summary>Always passes.</summary>
    Always,
}

/// <summary>Faces left out.</summary>
public enum GpuCull
{
    /// <summary>None.</summary>
    Off,

    /// <summary>Front faces.</summary>
    Front,

    /// <summary>Back faces.</summary>
    Back,
}

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

/// <summary>Channels that are written.</summary>
[Flags]
public enum GpuColorMask
{
    /// <summary>Red.</summary>
    Red = 1,

    /// <summary>Green.</summary>
    Green = 2,

    /// <summary>Blue.</summary>
    Blue = 4,

    /// <summary>Alpha.</summary>
    Alpha = 8,

    /// <summary>All four.</summary>
    All = 15,
}

/// <summary>How vertices form primitives.</summary>
public enum GpuTopology
{
    /// <summary>Three vertices a triangle.</summary>
    Triangles,

    /// <summary>Strip of triangles.</summary>
    TriangleStrip,

    /// <summary>Two vertices a line.</summary>
    Lines,

    /// <summary>Strip of lines.</summary>
    LineStrip,

    /// <summary>One vertex a point.</summary>
    Points,
}

/// <summary>Components of a vertex attribute.</summary>
public enum GpuVertexFormat
{
    /// <summary>One 32-bit float.</summary>
    Float1,

    /// <summary>Two 32-bit floats.</summary>
    Float2,

    /// <summary>Three 32-bit floats.</summary>
    Float3,

    /// <summary>Four 32-bit floats.</summary>
    Float4,

    /// <summary>Two 16-bit floats.</summary>
    Half2,

    /// <summary>Four 16-bit floats.</summary>
    Half4,

    /// <summary>Four bytes, 0 to 1.</summary>
    UNorm8x4,

    /// <summary>One unsigned integer.</summary>
    UInt1,

    /// <summary>Two unsigned integers.</summary>
    UInt2,

    /// <summary>Three unsigned integers.</summary>
    UInt3,

    /// <summary>Four unsigned integers.</summary>
    UInt4,
}
