namespace Headless.Checks.Shaders;

/// <summary>A branch, or the end of a loop, that hangs on uniforms and constants alone.</summary>
/// <param name="Uniforms">Names of the uniforms, with spaces between.</param>
/// <param name="Line">Line in the compiled text, counted from 1; 0 where the code names no lines.</param>
internal sealed record UniformBranch(string Uniforms, bool EndsLoop, int Line);
