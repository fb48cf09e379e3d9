namespace Headless.Shaders;

/// <summary>Lets the variable of a for loop live on to the end of the block around the loop, as in FXC.</summary>
/// <remarks>
/// for (int i = 0; i &lt; 3; i++) { } R[0] = i; becomes int i_for0; for (i_for0 = 0; i_for0 &lt; 3; i_for0++) { } R[0] = i_for0;
/// Where several loops or an outer declaration have the name, the most recent one counts (FXC's warning X3078). A loop
/// whose variable nobody uses after it stays as it is.
/// </remarks>
internal static class LoopScopes
{
    public static string Rewrite(string text)
    {
        int number = 0;
        while (Next(text, number) is { } changed)
        {
            text = changed;
            number++;
        }
        return text;
    }

    // One loop a turn: the tokens are read anew, so that loops in loops see the names given before.
    private static string? Next(string text, int number)
    {
        List<HlslToken> tokens = HlslTokens.Read(text);
        for (int i = 0; i + 4 < tokens.Count; i++)
        {
            if (tokens[i].Text == "for" && tokens[i + 1].Text == "(" && tokens[i + 2].IsWord && tokens[i + 3].IsWord
                && tokens[i + 4].Text is "=" && BeginsStatement(tokens, i))
            {
                if (Uses(tokens, i) is { Count: > 0 } uses)
                {
                    return Hoist(text, tokens, i, uses, $"{tokens[i + 3].Text}_for{number}");
                }
            }
        }
        return null;
    }

    // Not "if (x) for (int i = ...)", where a declaration before the loop would take its place.
    private static bool BeginsStatement(List<HlslToken> tokens, int loop) =>
        Attributes(tokens, loop) is > 0 and int first && tokens[first - 1].Text is ";" or "{" or "}";

    /// <summary>The first token of [unroll] and the like before a loop; the loop itself without them.</summary>
    private static int Attributes(List<HlslToken> tokens, int loop)
    {
        while (loop > 0 && tokens[loop - 1].Text == "]")
        {
            int depth = tokens[loop - 1].Parentheses;
            loop = tokens.FindLastIndex(loop - 1, t => t.Text == "[" && t.Parentheses == depth);
        }
        return loop;
    }

    private static string Hoist(string text, List<HlslToken> tokens, int loop, List<int> uses, string name)
    {
        TextEdit edit = new(text);
        string variable = tokens[loop + 3].Text;
        HlslToken type = tokens[loop + 2];
        int end = End(tokens, loop);
        edit.Replace(tokens[Attributes(tokens, loop)].Start, 0, $"{type.Text} {name}; ");
        edit.Replace(type.Start, type.Text.Length, "");
        for (int i = loop + 3; i < end; i++)
        {
            if (tokens[i].Text == variable && tokens[i - 1].Text != ".")
            {
                edit.Replace(tokens[i].Start, variable.Length, name);
            }
        }
        uses.ForEach(use => edit.Replace(tokens[use].Start, variable.Length, name));
        return edit.ToString();
    }

    /// <summary>Where the loop's variable is used after it: up to the next declaration of the name, or the block's end.</summary>
    private static List<int> Uses(List<HlslToken> tokens, int loop)
    {
        List<int> uses = [];
        string name = tokens[loop + 3].Text;
        int depth = tokens[loop].Braces;
        int inner = -1;
        for (int i = End(tokens, loop); i < tokens.Count && tokens[i].Braces >= depth && depth > 0; i++)
        {
            if (inner >= 0 && tokens[i].Braces < inner)
            {
                inner = -1;
            }
            if (tokens[i].Text != name || tokens[i - 1].Text == "." || inner >= 0)
            {
                continue;
            }
            bool declared = tokens[i - 1].IsWord && tokens[i - 1].Text is not ("return" or "else" or "case" or "do");
            if (!declared)
            {
                uses.Add(i);
            }
            else if (tokens[i].Braces == depth)
            {
                break;
            }
            else
            {
                // A declaration in an inner block hides the name to the end of that block.
                inner = tokens[i].Braces;
            }
        }
        return uses;
    }

    /// <summary>The token after the loop's last.</summary>
    private static int End(List<HlslToken> tokens, int loop)
    {
        int close = tokens.FindIndex(loop + 2, t => t.Text == ")" && t.Parentheses == tokens[loop + 1].Parentheses);
        return StatementEnd(tokens, close < 0 ? tokens.Count : close + 1);
    }

    private static int StatementEnd(List<HlslToken> tokens, int at)
    {
        while (at < tokens.Count && tokens[at].Text == "[")
        {
            int open = tokens[at].Parentheses;
            at = tokens.FindIndex(at + 1, t => t.Text == "]" && t.Parentheses == open) + 1;
        }
        if (at >= tokens.Count)
        {
            return tokens.Count;
        }
        (int braces, int parentheses) = (tokens[at].Braces, tokens[at].Parentheses);
        switch (tokens[at].Text)
        {
            case "{":
                return Past(tokens, tokens.FindIndex(at + 1, t => t.Text == "}" && t.Braces == braces));
            case "for" or "while" or "if" or "switch":
                int close = tokens.FindIndex(at + 2, t => t.Text == ")" && t.Parentheses == parentheses);
                int end = StatementEnd(tokens, Past(tokens, close));
                return tokens[at].Text == "if" && end < tokens.Count && tokens[end].Text == "else" ? StatementEnd(tokens, end + 1) : end;
            case "do":
                end = StatementEnd(tokens, at + 1);
                return Past(tokens, tokens.FindIndex(end, t => t.Text == ";" && t.Parentheses == parentheses));
            default:
                return Past(tokens, tokens.FindIndex(at, t => t.Text == ";" && t.Braces == braces && t.Parentheses == parentheses));
        }
    }

    private static int Past(List<HlslToken> tokens, int found) => found < 0 ? tokens.Count : found + 1;
}
