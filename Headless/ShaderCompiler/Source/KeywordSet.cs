namespace Headless.Shaders;

/// <summary>One multi_compile, shader_feature or dynamic_branch line: exactly one of the keywords is on.</summary>
/// <param name="Keywords">In order; "" stands for the variant with none of them ("_", "__").</param>
/// <param name="Local">Declared with the _local suffix.</param>
/// <param name="Feature">A shader_feature line.</param>
public sealed record KeywordSet(IReadOnlyList<string> Keywords, bool Local, bool Feature)
{
    /// <summary>A dynamic_branch line: the code asks "if (KEYWORD)", and each of its keywords is true or false there.</summary>
    public bool Branch { get; init; }
}
