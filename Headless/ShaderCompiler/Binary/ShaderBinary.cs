namespace Headless.Shaders;

/// <summary>A compiled entry point: SPIR-V 1.3 for Vulkan, D3D11 memory layouts (needs scalarBlockLayout).</summary>
/// <remarks>
/// The descriptor set of every resource is <see cref="DescriptorSet"/>; bindings are unique within it. Clip space is
/// D3D11's (y up, depth 0 to 1): draw with a viewport of negative height.
/// </remarks>
/// <param name="Inputs">Vertex attributes of a vertex stage; otherwise empty.</param>
/// <param name="SharedBytes">Bytes of groupshared memory.</param>
/// <param name="Hash">Content hash of the SPIR-V: equal hashes mean equal pipelines.</param>
public sealed record ShaderBinary(
    ShaderStage Stage,
    string EntryPoint,
    byte[] SpirV,
    IReadOnlyList<ShaderResource> Resources,
    IReadOnlyList<VertexInput> Inputs,
    int GroupX,
    int GroupY,
    int GroupZ,
    int SharedBytes,
    string Hash)
{
    /// <summary>Input primitive of a geometry stage: "point", "line", "triangle"; otherwise "".</summary>
    public string InputPrimitive { get; init; } = "";

    /// <summary>Whether Direct3D's own compiler made the code (see <see cref="Direct3DFrontEnd"/>).</summary>
    public bool ByDirect3D { get; init; }

    /// <summary>Compute 0; vertex 0, geometry 1, fragment 2.</summary>
    public int DescriptorSet => Stage switch
    {
        ShaderStage.Geometry => 1,
        ShaderStage.Fragment => 2,
        _ => 0,
    };
}
