namespace Headless.Vulkan;

/// <summary>One vertex stream.</summary>
/// <param name="Slot">The slot that <see cref="CommandRecorder.SetVertexBuffer"/> binds.</param>
/// <param name="Stride">Bytes from one vertex to the next; 0 repeats the same data for every vertex.</param>
/// <param name="PerInstance">Advances per instance and not per vertex.</param>
public readonly record struct VertexStream(int Slot, int Stride, bool PerInstance = false);
