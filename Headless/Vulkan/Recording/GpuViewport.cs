namespace Headless.Vulkan;

/// <summary>Viewport in texels, origin at the top left as in D3D11.</summary>
public readonly record struct GpuViewport(float X, float Y, float Width, float Height, float MinDepth = 0, float MaxDepth = 1);
