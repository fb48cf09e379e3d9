namespace Headless.Shaders;

/// <summary>A fixed number or the name of a material property that holds it ("Cull [_Cull]").</summary>
/// <param name="Value">Number as in UnityEngine.Rendering's enums; used when Property is null or absent in the shader.</param>
public readonly record struct RenderStateValue(float Value, string? Property = null)
{
    public static implicit operator RenderStateValue(float value) => new(value);
}
