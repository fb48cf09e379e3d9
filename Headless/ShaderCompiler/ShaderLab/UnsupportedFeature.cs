namespace Headless.Shaders;

/// <summary>Something Unity knows and the headless player does not; an error only when the pass is used.</summary>
internal sealed record UnsupportedFeature(int Line, string Message);
