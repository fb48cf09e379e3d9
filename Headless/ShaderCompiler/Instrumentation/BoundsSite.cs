namespace Headless.Shaders;

/// <summary>A place in a shader where an array or buffer is indexed.</summary>
/// <param name="Shader">Entry point.</param>
/// <param name="Variable">Name of the buffer or array.</param>
public sealed record BoundsSite(string Shader, string Variable);
