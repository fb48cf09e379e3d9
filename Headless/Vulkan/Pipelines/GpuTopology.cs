namespace Headless.Vulkan;

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
