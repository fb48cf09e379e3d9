namespace Headless.Shaders;

/// <summary>Takes semicolons of nothing out of structures and constant buffers, where glslang refuses them: <c>float a;; float b;</c></summary>
internal static class StraySemicolons
{
    /// <param name="text">Text behind the preprocessor, where macros that stand for nothing have left their semicolons.</param>
    public static string Remove(string text)
    {
        List<HlslToken> tokens = HlslTokens.Read(text);
        TextEdit edit = new(text);
        for (int i = 1; i < tokens.Count; i++)
        {
            if (tokens[i] is { Text: ";", Parentheses: 0 } && tokens[i - 1].Text is ";" or "{")
            {
                edit.Blank(tokens[i].Start, tokens[i].End);
            }
        }
        return edit.ToString();
    }
}
