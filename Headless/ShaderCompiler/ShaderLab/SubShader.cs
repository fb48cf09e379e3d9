namespace Headless.Shaders;

/// <param name="Lod">0 where none is given.</param>
public sealed record SubShader(IReadOnlyDictionary<string, string> Tags, int Lod, IReadOnlyList<ShaderPass> Passes);
