namespace Headless.Vulkan;

/// <summary>One input of the vertex shader.</summary>
/// <param name="Location">The shader's input location.</param>
/// <param name="Format">Components in memory.</param>
/// <param name="Offset">Bytes from the start of the vertex.</param>
/// <param name="Slot">Vertex buffer slot.</param>
public readonly record struct VertexAttribute(int Location, GpuVertexFormat Format, int Offset, int Slot);

/// <summary>One vertex stream.</summary>
/// <param name="Slot">The slot that <see cref="CommandRecorder.SetVertexBuffer"/> binds.</param>
/// <param name="Stride">Bytes from one vertex to the next; 0 repeats the same data for every vertex.</param>
/// <param name="PerInstance">Advances per instance and not per vertex.</param>
public readonly record struct VertexStream(int Slot, int Stride, bool PerInstance = false);
