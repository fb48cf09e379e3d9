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
