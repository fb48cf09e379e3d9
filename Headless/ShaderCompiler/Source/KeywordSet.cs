namespace Headless.Shaders;

/// <summary>One multi_compile or shader_feature line: exactly one of the keywords is on.</summary>
/// <param name="Keywords">In order; "" stands for the variant with none of them ("_", "__").</param>
/// <param name="Local">Declared with the _local suffix.</param>
/// <param name="Feature">A shader_feature line.</param>
public sealed record KeywordSet(IReadOnlyList<string> Keywords, bool Local, bool Feature);
