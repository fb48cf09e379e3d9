namespace Headless.Shaders;

/// <summary>A resource that the entry point uses (unused declarations are removed, as FXC does).</summary>
/// <param name="Binding">Binding number, unique within the stage's descriptor set.</param>
/// <param name="Size">Bytes of a constant buffer, a multiple of 16; otherwise 0.</param>
/// <param name="Stride">Bytes of an element of a structured buffer in D3D11's tight layout; otherwise 0.</param>
/// <param name="Members">Members of a constant buffer; otherwise empty.</param>
/// <param name="Dimension">"2D", "3D", "Cube", "2DArray", "CubeArray", "2DMS", "Buffer" for textures; otherwise "".</param>
public sealed record ShaderResource(
    string Name, ResourceKind Kind, int Binding, int Size, int Stride, IReadOnlyList<ConstantMember> Members, string Dimension)
{
    /// <summary>SPIR-V format of a RWTexture in the binary (see <see cref="ImageFormats"/>); otherwise Unknown.</summary>
    public ImageFormat Format { get; init; }

    /// <summary>"float", "int" or "uint": what reading a texture yields; otherwise "".</summary>
    public string SampledType { get; init; } = "";

    /// <summary>True for a SamplerComparisonState.</summary>
    public bool Comparison { get; init; }

    /// <summary>Number n of register(un) of what a shader writes, given or assigned; otherwise -1.</summary>
    public int Register { get; init; } = -1;

    /// <summary>Elements of an array of textures or samplers; otherwise 1.</summary>
    public int Count { get; init; } = 1;
}
