namespace Headless.Shaders;

/// <summary>Splits HLSL that is not preprocessed yet into tokens; comments and directives are left out.</summary>
/// <remarks>Both branches of an #if are read; the depth of brackets at #else is that at #if.</remarks>
internal static class HlslTokens
{
    public static List<HlslToken> Read(string text)
    {
        List<HlslToken> tokens = [];
        Stack<(int Braces, int Parentheses)> conditions = [];
        int braces = 0;
        int parentheses = 0;
        bool lineStart = true;
        for (int at = 0; at < text.Length;)
        {
            char c = text[at];
            if (c == '\n' || char.IsWhiteSpace(c))
            {
                lineStart |= c == '\n';
                at++;
            }
            else if (Comment(text, at) is > 0 and int end)
            {
                at = end;
            }
            else if (c == '#' && lineStart)
            {
                int stop = DirectiveEnd(text, at);
                Condition(text[(at + 1)..stop].TrimStart(), conditions, ref braces, ref parentheses);
                at = stop;
            }
            else
            {
                lineStart = false;
                int length = Length(text, at);
                parentheses -= c is ')' or ']' ? 1 : 0;
                braces -= c == '}' ? 1 : 0;
                tokens.Add(new HlslToken(text.Substring(at, length), at, braces, parentheses));
                parentheses += c is '(' or '[' ? 1 : 0;
                braces += c == '{' ? 1 : 0;
                at += length;
            }
        }
        return tokens;
    }

    private static int Length(string text, int at)
    {
        if (text[at] == '"')
        {
            int close = text.IndexOf('"', at + 1);
            return (close < 0 ? text.Length : close + 1) - at;
        }
        int end = at;
        bool number = char.IsDigit(text[at]);
        while (end < text.Length && (char.IsLetterOrDigit(text[end]) || text[end] == '_' || (number && text[end] == '.')))
        {
            end++;
        }
        return Math.Max(1, end - at);
    }

    private static int Comment(string text, int at)
    {
        if (text[at] != '/' || at + 1 == text.Length)
        {
            return -1;
        }
        int end = text[at + 1] switch
        {
            '/' => text.IndexOf('\n', at),
            '*' => text.IndexOf("*/", at + 2, StringComparison.Ordinal) is >= 0 and int close ? close + 2 : -1,
            _ => 0,
        };
        return end < 0 ? text.Length : end;
    }

    private static int DirectiveEnd(string text, int at)
    {
        int end = at;
        do
        {
            end = text.IndexOf('\n', end + 1);
        }
        while (end > 0 && text[end - (text[end - 1] == '\r' ? 2 : 1)] == '\\');
        return end < 0 ? text.Length : end;
    }

    private static void Condition(string directive, Stack<(int, int)> conditions, ref int braces, ref int parentheses)
    {
        if (directive.StartsWith("if", StringComparison.Ordinal))
        {
            conditions.Push((braces, parentheses));
        }
        else if (directive.StartsWith("el", StringComparison.Ordinal) && conditions.Count > 0)
        {
            (braces, parentheses) = conditions.Peek();
        }
        else if (directive.StartsWith("endif", StringComparison.Ordinal) && conditions.Count > 0)
        {
            conditions.Pop();
        }
    }
}
