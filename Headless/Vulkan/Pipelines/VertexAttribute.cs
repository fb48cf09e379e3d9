namespace Headless.Vulkan;

/// <summary>One input of the vertex shader.</summary>
/// <param name="Location">The shader's input location.</param>
/// <param name="Format">Components in memory.</param>
/// <param name="Offset">Bytes from the start of the vertex.</param>
/// <param name="Slot">Vertex buffer slot.</param>
public readonly record struct VertexAttribute(int Location, GpuVertexFormat Format, int Offset, int Slot);
