using System.Globalization;

namespace Headless.Shaders.Preprocessing;

/// <summary>Works out the condition of an #if, where it does not depend on the variant.</summary>
/// <remarks>The arithmetic is glslang's, 32 bits with a sign. What glslang would refuse is not known: it says so itself.</remarks>
internal sealed class Condition
{
    private const int MostNested = 200;

    private static readonly string[][] Levels =
        [["||"], ["&&"], ["|"], ["^"], ["&"], ["==", "!="], ["<", ">", "<=", ">="], ["<<", ">>"], ["+", "-"], ["*", "/", "%"]];

    private readonly List<string> _tokens;
    private int _at;
    private int _depth;
    private bool _malformed;

    private Condition(List<string> tokens) => _tokens = tokens;

    /// <summary>Null where it depends on the variant or is malformed.</summary>
    /// <param name="tokens">Without macros; <see cref="MacroExpansion.Unknown"/> is a number that is not known.</param>
    public static bool? IsTrue(List<string> tokens)
    {
        Condition condition = new(tokens);
        int? value = condition.Binary(0);
        return condition._malformed || condition._at != tokens.Count ? null : value is { } known ? known != 0 : null;
    }

    private string Peek => _at < _tokens.Count ? _tokens[_at] : "";

    private int? Binary(int level)
    {
        if (level == Levels.Length) return Unary();
        int? left = Binary(level + 1);
        while (!_malformed && Levels[level].Contains(Peek))
        {
            string sign = _tokens[_at++];
            left = Result(sign, left, Binary(level + 1));
        }
        return left;
    }

    private int? Unary()
    {
        if (_malformed || _depth >= MostNested) return Malformed();
        _depth++;
        int? value = Operand();
        _depth--;
        return value;
    }

    private int? Operand()
    {
        string token = Peek;
        _at++;
        switch (token)
        {
            case "!":
                return Unary() is { } truth ? (truth == 0 ? 1 : 0) : null;
            case "-":
                return unchecked(-Unary());
            case "+":
                return Unary();
            case "~":
                return ~Unary();
            case "(":
                int? inner = Binary(0);
                if (Peek != ")") return Malformed();
                _at++;
                return inner;
            case MacroExpansion.Unknown:
                return null;
            case "":
                return Malformed();
        }
        // A name that nobody defined is 0.
        if (DirectiveTokens.IsName(token)) return Peek == "(" ? Malformed() : 0;
        return Number(token.TrimEnd('u', 'U')) ?? Malformed();
    }

    private int? Malformed()
    {
        _malformed = true;
        return null;
    }

    private static int? Result(string sign, int? left, int? right)
    {
        if (sign == "&&" && (left is 0 || right is 0)) return 0;
        if (sign == "||" && (left is not (null or 0) || right is not (null or 0))) return 1;
        if (left is not { } a || right is not { } b) return null;
        return sign switch
        {
            "||" or "&&" => a != 0 && b != 0 ? 1 : 0,
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

    private static int? Number(string text)
    {
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
