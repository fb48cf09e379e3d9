namespace Headless.Mutation.Hlsl;

internal enum HlslTokenKind { Name, Number, Symbol }

/// <summary>A token of HLSL by its place in the text.</summary>
internal readonly record struct HlslToken(HlslTokenKind Kind, string Text, int Start)
{
    public int End => Start + Text.Length;

    public bool Is(string text) => Text == text;
}
