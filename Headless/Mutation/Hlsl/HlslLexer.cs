namespace Headless.Mutation.Hlsl;

/// <summary>Splits HLSL into tokens. Comments and preprocessor lines, with their continuations, are left out.</summary>
internal static class HlslLexer
{
    private static readonly string[] Symbols =
        ["<<=", ">>=", "++", "--", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<", ">>", "<=", ">=", "==", "!=", "&&", "||", "::"];

    public static List<HlslToken> Read(string text)
    {
        List<HlslToken> tokens = [];
        int at = 0;
        while (at < text.Length)
        {
            char c = text[at];
            if (char.IsWhiteSpace(c)) at++;
            else if (c == '#') at = EndOfDirective(text, at);
            else if (Begins(text, at, "//")) at = EndOf(text, at, "\n");
            else if (Begins(text, at, "/*")) at = EndOf(text, at + 2, "*/");
            else
            {
                HlslToken token = Next(text, at);
                tokens.Add(token);
                at = token.End;
            }
        }
        return tokens;
    }

    private static HlslToken Next(string text, int at)
    {
        char c = text[at];
        int end = at + 1;
        if (char.IsLetter(c) || c == '_')
        {
            while (end < text.Length && IsWord(text[end])) end++;
            return new HlslToken(HlslTokenKind.Name, text[at..end], at);
        }
        if (char.IsDigit(c) || (c == '.' && end < text.Length && char.IsDigit(text[end])))
        {
            while (end < text.Length && (IsWord(text[end]) || text[end] == '.' || (text[end] is '+' or '-' && text[end - 1] is 'e' or 'E' && !Begins(text, at, "0x")))) end++;
            return new HlslToken(HlslTokenKind.Number, text[at..end], at);
        }
        if (c == '"')
        {
            while (end < text.Length && text[end] != '"') end++;
            return new HlslToken(HlslTokenKind.Symbol, text[at..Math.Min(end + 1, text.Length)], at);
        }
        string symbol = Symbols.FirstOrDefault(s => Begins(text, at, s)) ?? c.ToString();
        return new HlslToken(HlslTokenKind.Symbol, symbol, at);
    }

    private static bool IsWord(char c) => char.IsLetterOrDigit(c) || c == '_';

    private static bool Begins(string text, int at, string with) => string.CompareOrdinal(text, at, with, 0, with.Length) == 0;

    private static int EndOf(string text, int from, string mark)
    {
        int at = text.IndexOf(mark, from, StringComparison.Ordinal);
        return at < 0 ? text.Length : at + mark.Length;
    }

    private static int EndOfDirective(string text, int at)
    {
        while (true)
        {
            int end = text.IndexOf('\n', at);
            if (end < 0) return text.Length;
            if (end == 0 || text[..end].TrimEnd('\r')[^1] != '\\') return end + 1;
            at = end + 1;
        }
    }
}
