namespace Headless.Shaders;

/// <summary>A line of a shader's Properties block.</summary>
/// <param name="Default">Four numbers; scalars stand in the first. A texture's are 0.</param>
/// <param name="DefaultTexture">"white", "black", "gray", "bump", "red" or "" for textures; otherwise "".</param>
/// <param name="Attributes">Text inside each [ ] before the name, such as "HDR" or "Toggle(_X)".</param>
public sealed record ShaderProperty(
    string Name, string Display, ShaderPropertyType Type, IReadOnlyList<float> Default, string DefaultTexture,
    IReadOnlyList<string> Attributes)
{
    public float RangeMin { get; init; }
    public float RangeMax { get; init; }
}
