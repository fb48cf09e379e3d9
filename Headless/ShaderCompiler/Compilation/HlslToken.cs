namespace Headless.Shaders;

/// <summary>A word, number or sign of HLSL text.</summary>
/// <param name="Start">Index of its first character.</param>
/// <param name="Braces">Open braces before it.</param>
/// <param name="Parentheses">Open round and square brackets before it.</param>
internal readonly record struct HlslToken(string Text, int Start, int Braces, int Parentheses)
{
    public int End => Start + Text.Length;

    public bool IsWord => char.IsLetter(Text[0]) || Text[0] == '_';
}
