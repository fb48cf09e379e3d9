namespace Headless.Shaders;

/// <param name="Semantic">Upper case with its index where it is not 0 or was written: "POSITION", "TEXCOORD0".</param>
public sealed record VertexInput(string Semantic, int Location, int Components, bool Integer);
