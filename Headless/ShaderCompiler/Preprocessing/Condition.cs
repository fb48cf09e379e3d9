using System.Globalization;

namespace Headless.Shaders.Preprocessing;

/// <summary>Works out when the condition of an #if holds.</summary>
/// <remarks>The arithmetic is glslang's, 32 bits with a sign. What glslang would refuse is unknown: it says so itself.</remarks>
internal sealed class Condition
{
    private const int MostNested = 200;

    private static readonly string[][] Levels =
        [["||"], ["&&"], ["|"], ["^"], ["&"], ["==", "!="], ["<", ">", "<=", ">="], ["<<", ">>"], ["+", "-"], ["*", "/", "%"]];

    private readonly List<MacroExpansion.Token> _tokens;
    private readonly Decisions _decisions;
    private int _at;
    private int _depth;
    private bool _malformed;

    private Condition(List<MacroExpansion.Token> tokens, Decisions decisions) => (_tokens, _decisions) = (tokens, decisions);

    /// <summary>When it holds; null where that cannot be told.</summary>
    /// <param name="tokens">Without macros.</param>
    public static int? IsTrue(List<MacroExpansion.Token> tokens, Decisions decisions)
    {
        Condition condition = new(tokens, decisions);
        Cases value = condition.Binary(0);
        return condition._malformed || condition._at != tokens.Count || !value.IsKnown ? null : value.IsTrue(decisions);
    }

    private string Peek => _at < _tokens.Count ? _tokens[_at].Text : "";

    private Cases Binary(int level)
    {
        if (level == Levels.Length) return Unary();
        Cases left = Binary(level + 1);
        while (!_malformed && Levels[level].Contains(Peek))
        {
            string sign = _tokens[_at++].Text;
            left = Result(sign, left, Binary(level + 1));
        }
        return left;
    }

    private Cases Unary()
    {
        if (_malformed || _depth >= MostNested) return Malformed();
        _depth++;
        Cases value = Operand();
        _depth--;
        return value;
    }

    private Cases Operand()
    {
        string token = Peek;
        if (_at < _tokens.Count && _tokens[_at].Cases is { } cases)
        {
            _at++;
            return cases;
        }
        _at++;
        switch (token)
        {
            case "!":
                return Unary().Map(_decisions, value => value == 0 ? 1 : 0);
            case "-":
                return Unary().Map(_decisions, value => unchecked(-value));
            case "+":
                return Unary();
            case "~":
                return Unary().Map(_decisions, value => ~value);
            case "(":
                Cases inner = Binary(0);
                if (Peek != ")") return Malformed();
                _at++;
                return inner;
            case "":
                return Malformed();
        }
        // A name that nobody defined is 0.
        if (DirectiveTokens.IsName(token)) return Peek == "(" ? Malformed() : Cases.Of(0);
        return Number(token) is { } number ? Cases.Of(number) : Malformed();
    }

    private Cases Malformed()
    {
        _malformed = true;
        return Cases.Unknown;
    }

    private Cases Result(string sign, Cases left, Cases right)
    {
        if (sign is "&&" or "||")
        {
            int stops = sign == "&&" ? 0 : 1;
            if (Always(left, stops) || Always(right, stops)) return Cases.Of(stops);
        }
        return left.IsKnown && right.IsKnown ? left.With(_decisions, right, (a, b) => Result(sign, a, b)) : Cases.Unknown;
    }

    private static bool Always(Cases cases, int truth) => cases.IsKnown && cases.All.All(c => (c.Value != 0 ? 1 : 0) == truth);

    private static int? Result(string sign, int a, int b)
    {
        return sign switch
        {
            "||" => a != 0 || b != 0 ? 1 : 0,
            "&&" => a != 0 && b != 0 ? 1 : 0,
            "|" => a | b,
            "^" => a ^ b,
            "&" => a & b,
            "==" => a == b ? 1 : 0,
            "!=" => a != b ? 1 : 0,
            "<" => a < b ? 1 : 0,
            ">" => a > b ? 1 : 0,
            "<=" => a <= b ? 1 : 0,
            ">=" => a >= b ? 1 : 0,
            "<<" => b is >= 0 and < 32 ? a << b : null,
            ">>" => b is >= 0 and < 32 ? a >> b : null,
            "+" => unchecked(a + b),
            "-" => unchecked(a - b),
            "*" => unchecked(a * b),
            _ when b is 0 or -1 => null,
            "/" => a / b,
            _ => a % b,
        };
    }

    /// <summary>Null where a text is no whole number.</summary>
    public static int? Number(string written)
    {
        string text = written.TrimEnd('u', 'U');
        if (text.StartsWith("0x", StringComparison.OrdinalIgnoreCase))
        {
            return uint.TryParse(text.AsSpan(2), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out uint hex) ? unchecked((int)hex) : null;
        }
        if (text.Length > 1 && text[0] == '0')
        {
            return text.Length <= 11 && text.All(c => c is >= '0' and <= '7') ? (int)text.Aggregate(0L, (value, c) => value * 8 + c - '0') : null;
        }
        return int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int value) ? value : null;
    }
}
