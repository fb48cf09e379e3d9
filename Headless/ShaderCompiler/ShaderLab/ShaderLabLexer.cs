namespace Headless.Shaders;

/// <summary>Splits ShaderLab into words, quoted texts, symbols and program blocks.</summary>
internal sealed class ShaderLabLexer(string file, string text)
{
    private static readonly Dictionary<string, string> BlockEnds = new(StringComparer.OrdinalIgnoreCase)
    {
        ["CGPROGRAM"] = "ENDCG",
        ["CGINCLUDE"] = "ENDCG",
        ["HLSLPROGRAM"] = "ENDHLSL",
        ["HLSLINCLUDE"] = "ENDHLSL",
        ["GLSLPROGRAM"] = "ENDGLSL",
        ["GLSLINCLUDE"] = "ENDGLSL",
    };

    private const int MostTokens = 1_000_000;

    private int _at;
    private int _line = 1;

    public List<ShaderLabToken> Read()
    {
        List<ShaderLabToken> tokens = [];
        do
        {
            if (tokens.Count >= MostTokens)
            {
                throw new ShaderCompileException(file, _line, $"more than {MostTokens} words and symbols; divide the shader");
            }
            tokens.Add(Next());
        }
        while (tokens[^1].Kind != ShaderLabTokenKind.End);
        return tokens;
    }

    private ShaderLabToken Next()
    {
        SkipBlanks();
        if (_at >= text.Length)
        {
            return new ShaderLabToken(ShaderLabTokenKind.End, "end of file", _line);
        }
        char c = text[_at];
        if (c == '"')
        {
            return Quoted();
        }
        if (IsWord(c) || (c is '-' or '+' && _at + 1 < text.Length && IsWord(text[_at + 1])))
        {
            return Word();
        }
        if ("{}()[]=,:".Contains(c))
        {
            _at++;
            return new ShaderLabToken(ShaderLabTokenKind.Symbol, c.ToString(), _line);
        }
        throw new ShaderCompileException(file, _line, $"unexpected character '{c}'; correct the line");
    }

    private ShaderLabToken Quoted()
    {
        int end = text.IndexOf('"', _at + 1);
        int newline = text.IndexOf('\n', _at);
        if (end < 0 || (newline >= 0 && newline < end))
        {
            throw new ShaderCompileException(file, _line, "text without closing quote");
        }
        ShaderLabToken token = new(ShaderLabTokenKind.Text, text[(_at + 1)..end], _line);
        _at = end + 1;
        return token;
    }

    private ShaderLabToken Word()
    {
        int start = _at++;
        while (_at < text.Length && (IsWord(text[_at]) || IsExponentSign(start)))
        {
            _at++;
        }
        string word = text[start.._at];
        return BlockEnds.TryGetValue(word, out string? end) ? Block(word, end) : new ShaderLabToken(ShaderLabTokenKind.Word, word, _line);
    }

    private ShaderLabToken Block(string keyword, string endWord)
    {
        int end = FindWord(endWord);
        if (end < 0)
        {
            throw new ShaderCompileException(file, _line, $"{keyword} without {endWord}");
        }
        ShaderLabToken token = new(ShaderLabTokenKind.Program, text[_at..end], _line, keyword.ToUpperInvariant());
        _line += token.Text.Count(c => c == '\n');
        _at = end + endWord.Length;
        return token;
    }

    private int FindWord(string word)
    {
        for (int at = _at; ; at++)
        {
            at = text.IndexOf(word, at, StringComparison.OrdinalIgnoreCase);
            if (at < 0)
            {
                return -1;
            }
            int after = at + word.Length;
            if (!IsWord(text[at - 1]) && (after == text.Length || !IsWord(text[after])))
            {
                return at;
            }
        }
    }

    private void SkipBlanks()
    {
        while (_at < text.Length)
        {
            if (text[_at] == '\n')
            {
                _line++;
                _at++;
            }
            else if (char.IsWhiteSpace(text[_at]) || text[_at] == '\uFEFF')
            {
                _at++;
            }
            else if (At("//"))
            {
                int end = text.IndexOf('\n', _at);
                _at = end < 0 ? text.Length : end;
            }
            else if (At("/*"))
            {
                int end = text.IndexOf("*/", _at + 2, StringComparison.Ordinal);
                if (end < 0)
                {
                    throw new ShaderCompileException(file, _line, "comment without */");
                }
                _line += text.AsSpan(_at, end - _at).Count('\n');
                _at = end + 2;
            }
            else
            {
                return;
            }
        }
    }

    private bool At(string mark) => string.CompareOrdinal(text, _at, mark, 0, mark.Length) == 0;

    // "1e-3", not "Front-Back"
    private bool IsExponentSign(int start) =>
        text[_at] is '-' or '+' && text[_at - 1] is 'e' or 'E' && (char.IsAsciiDigit(text[start]) || text[start] is '-' or '+' or '.');

    private static bool IsWord(char c) => char.IsAsciiLetterOrDigit(c) || c is '_' or '.';
}
