using System.Text.RegularExpressions;

namespace Headless.Shaders;

/// <summary>Makes every global that is not static a uniform without a value of its own, as FXC and Unity do.</summary>
/// <remarks>
/// "const float x;" is a uniform in HLSL, which glslang would take for a constant 0. "const float y = 3;" is one too (FXC's
/// warning X3207: "Initializer used on a global 'const' variable. This requires setting an external constant."); Unity does
/// not apply the initializer, so y reads 0 until it is set. "static const" is a literal.
/// </remarks>
internal static partial class GlobalInitializers
{
    private static readonly HashSet<string> OtherStatements =
        ["static", "groupshared", "struct", "class", "interface", "typedef", "cbuffer", "tbuffer", "namespace", "template"];

    public static string Rewrite(string text)
    {
        List<HlslToken> tokens = HlslTokens.Read(text);
        HashSet<string> others = [.. OtherStatements, .. StaticMacro().Matches(text).Select(m => m.Groups[1].Value)];
        TextEdit edit = new(text);
        int first = 0;
        for (int i = 0; i < tokens.Count; i++)
        {
            bool atTop = tokens[i].Braces == 0 && tokens[i].Parentheses == 0;
            if (atTop && tokens[i].Text == "}" && !IsInitializer(tokens, first, i))
            {
                first = i + 1;
            }
            else if (atTop && tokens[i].Text == ";")
            {
                Statement(tokens, first, i, others, edit);
                first = i + 1;
            }
        }
        return edit.IsEmpty ? text : edit.ToString();
    }

    private static bool IsInitializer(List<HlslToken> tokens, int first, int end)
    {
        int open = tokens.FindLastIndex(end - 1, end - first, t => t.Text == "{" && t.Braces == 0);
        return open > first && tokens[open - 1].Text == "=";
    }

    private static void Statement(List<HlslToken> tokens, int first, int end, HashSet<string> others, TextEdit edit)
    {
        if (end - first < 2)
        {
            return;
        }
        // A macro's call without a semicolon may stand before the declaration: what counts begins after its bracket.
        int assign = tokens.FindIndex(first, end - first, t => t is { Text: "=", Braces: 0, Parentheses: 0 });
        int last = assign < 0 ? end : assign;
        int start = tokens.FindLastIndex(last - 1, last - first, t => t is { Text: ")", Braces: 0, Parentheses: 0 }) + 1;
        if (start > first && tokens.FindIndex(start, last - start, t => t.Text == "(") < 0 && !IsRegister(tokens, first, start))
        {
            first = start;
        }
        else if (start > first && !IsRegister(tokens, first, start))
        {
            return;
        }
        List<HlslToken> words = tokens.GetRange(first, last - first);
        if (words.Count < 2 || words.Exists(t => others.Contains(t.Text)))
        {
            return;
        }
        foreach (HlslToken word in words.Where(t => t is { Text: "const", Parentheses: 0 }))
        {
            edit.Blank(word.Start, word.End);
        }
        for (int i = last; assign >= 0 && i < end; i++)
        {
            if (tokens[i] is not { Text: "=", Braces: 0, Parentheses: 0 })
            {
                continue;
            }
            int stop = tokens.FindIndex(i, end - i, t => t is { Text: ",", Braces: 0, Parentheses: 0 });
            stop = stop < 0 ? end : stop;
            edit.Blank(tokens[i].Start, tokens[stop].Start);
            i = stop;
        }
    }

    // #define TABLE static const
    [GeneratedRegex(@"#\s*define\s+(\w+).*\bstatic\b")]
    private static partial Regex StaticMacro();

    // float x : register(c0); and float x : packoffset(c0.x);
    private static bool IsRegister(List<HlslToken> tokens, int first, int start)
    {
        int open = tokens.FindIndex(first, start - first, t => t is { Text: "(", Parentheses: 0 });
        return open > first && tokens[open - 1].Text is "register" or "packoffset";
    }
}
