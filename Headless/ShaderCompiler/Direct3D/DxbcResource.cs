namespace Headless.Shaders.Direct3D;

/// <summary>A resource of a compiled Direct3D shader and the register that it is bound to.</summary>
/// <param name="Register">"t0", "u3", "cb1", "s0".</param>
/// <param name="Dimension">As in <see cref="ShaderResource.Dimension"/>; "" where it is no texture.</param>
/// <param name="SampledType">As in <see cref="ShaderResource.SampledType"/>.</param>
/// <param name="Stride">Bytes of an element of a structured buffer.</param>
internal sealed record DxbcResource(
    string Name, ResourceKind Kind, string Register, string Dimension, string SampledType, int Stride, int Count, bool Comparison);
