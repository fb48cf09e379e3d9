namespace Headless.Shaders;

/// <summary>A piece of HLSL of a file.</summary>
/// <param name="FirstLine">1-based line of the file on which the text begins.</param>
internal sealed record SourceBlock(string Path, string Text, int FirstLine);
