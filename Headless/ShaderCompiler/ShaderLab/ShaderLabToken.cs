namespace Headless.Shaders;

internal enum ShaderLabTokenKind
{
    Word,
    Text,
    Symbol,
    Program,
    End,
}

/// <summary>A token of ShaderLab. Program holds the raw HLSL of a block: its keyword in Keyword.</summary>
/// <param name="Line">1-based; of a program block: the line on which its text begins.</param>
internal sealed record ShaderLabToken(ShaderLabTokenKind Kind, string Text, int Line, string Keyword = "")
{
    public bool Is(string word) => Kind is ShaderLabTokenKind.Word or ShaderLabTokenKind.Symbol
        && string.Equals(Text, word, StringComparison.OrdinalIgnoreCase);
}
