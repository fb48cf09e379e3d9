using System.Text.RegularExpressions;

namespace Headless.Shaders;

/// <summary>Hands constant floats to fmod and % through functions, so that glslang leaves an instruction.</summary>
/// <remarks>
/// glslang 12 works remainders of constants out itself, and wrongly: fmod(-5.5, 2) becomes 0.5 where HLSL has -1.5, and
/// -5.5 % 2.0 becomes -5.5. The instruction it leaves otherwise is mended by <see cref="SpirV.Remainders"/>.
/// </remarks>
internal static partial class ConstantRemainders
{
    private const string Keep = "headless_runtime";

    private static readonly string[] Vectors = ["float", "float2", "float3", "float4"];

    private static readonly string Runtime = string.Concat(Vectors.Select(v => $"{v} {Keep}({v} x) {{ return x; }}\n"));

    // A macro of the name, so that macros of the source use it as well.
    private static readonly string Function =
        string.Concat(Vectors.Select(v => $"{v} headless_fmod({v} a, {v} b) {{ return fmod(a, b); }}\n")) + "#define fmod headless_fmod\n";

    public static string KeepFromFolding(string text)
    {
        bool function = text.Contains("fmod", StringComparison.Ordinal);
        if (!function && !text.Contains('%', StringComparison.Ordinal))
        {
            return text;
        }
        List<HlslToken> tokens = HlslTokens.Read(text);
        string start = function && !DefinesFunction(tokens) ? Function : "";
        HashSet<string> constants = [.. Constant().Matches(text).Select(m => m.Groups["name"].Value)];
        constants.ExceptWith(Integer().Matches(text).Select(m => m.Groups[1].Value));
        TextEdit edit = new(text);
        for (int i = 1; i + 1 < tokens.Count; i++)
        {
            if (tokens[i].Text == "%" && tokens[i + 1].Text != "=" && FloatOperand(tokens, i, constants) is var (first, last))
            {
                edit.Replace(tokens[first].Start, 0, Keep + "(");
                edit.Replace(tokens[last].End, 0, ")");
            }
        }
        return edit.IsEmpty ? start + text : start + Runtime + edit;
    }

    /// <summary>The tokens of an operand that is a constant float for sure; null where neither is.</summary>
    private static (int First, int Last)? FloatOperand(List<HlslToken> tokens, int sign, HashSet<string> constants)
    {
        int right = sign + 1;
        while (right + 1 < tokens.Count && tokens[right].Text is "-" or "+")
        {
            right++;
        }
        return From(tokens, right, constants) ?? To(tokens, sign - 1, constants);
    }

    private static (int, int)? From(List<HlslToken> tokens, int at, HashSet<string> constants)
    {
        if (tokens[at].Text == "." && at + 1 < tokens.Count && char.IsDigit(tokens[at + 1].Text[0]))
        {
            return (at, at + 1);
        }
        if (Number().IsMatch(tokens[at].Text))
        {
            return (at, at + (Exponent(tokens, at) ? 2 : 0));
        }
        if (constants.Contains(tokens[at].Text))
        {
            return (at, at);
        }
        if (at + 1 < tokens.Count && Type().IsMatch(tokens[at].Text) && tokens[at + 1].Text == "(")
        {
            int depth = tokens[at + 1].Parentheses;
            int close = tokens.FindIndex(at + 2, t => t.Text == ")" && t.Parentheses == depth);
            return close < 0 ? null : (at, close);
        }
        return null;
    }

    private static (int, int)? To(List<HlslToken> tokens, int at, HashSet<string> constants)
    {
        if (tokens[at].Text == ")")
        {
            int depth = tokens[at].Parentheses;
            int open = tokens.FindLastIndex(at - 1, t => t.Text == "(" && t.Parentheses == depth);
            bool constructs = open > 0 && Type().IsMatch(tokens[open - 1].Text);
            bool groups = open > 0 && !tokens[open - 1].IsWord && tokens[open - 1].Text is not (")" or "]")
                && tokens.GetRange(open, at - open) is var inner && inner.TrueForAll(t => IsArithmetic(t, constants))
                && inner.Exists(t => Number().IsMatch(t.Text) || constants.Contains(t.Text));
            return constructs ? (open - 1, at) : groups ? (open, at) : null;
        }
        // 2.5e-3: the number's last token is 3.
        if (at > 2 && tokens[at - 1].Text is "-" or "+" && Number().IsMatch(tokens[at - 2].Text) && Exponent(tokens, at - 2))
        {
            return (at - 2, at);
        }
        if (char.IsDigit(tokens[at].Text[0]) && at > 1 && tokens[at - 1].Text == "." && tokens[at - 1].End == tokens[at].Start)
        {
            return (at - 1, at);
        }
        bool member = at > 0 && tokens[at - 1].Text == ".";
        return !member && (Number().IsMatch(tokens[at].Text) || constants.Contains(tokens[at].Text)) ? (at, at) : null;
    }

    // (2.0 - Half * 3): whole numbers among floats, no names but constants.
    private static bool IsArithmetic(HlslToken token, HashSet<string> constants) =>
        token.Text is "+" or "-" or "*" or "/" or "(" or ")" or "." || char.IsDigit(token.Text[0]) || constants.Contains(token.Text);

    private static bool Exponent(List<HlslToken> tokens, int at) =>
        tokens[at].Text[^1] is 'e' or 'E' && at + 2 < tokens.Count && tokens[at + 1].Text is "-" or "+" && tokens[at + 1].Start == tokens[at].End;

    private static bool DefinesFunction(List<HlslToken> tokens) => Enumerable.Range(1, Math.Max(0, tokens.Count - 1))
        .Any(i => tokens[i].Text == "fmod" && tokens[i - 1].IsWord && tokens[i - 1].Text is not ("return" or "else" or "case" or "do"));

    // 2.0, 2., 2e3, 2f; not 0x2f.
    [GeneratedRegex(@"^(?!0[xX])[0-9]+([.eEfFhH]\w*)$")]
    private static partial Regex Number();

    [GeneratedRegex(@"^(float|half|fixed|min16float|min10float)[1-4]?$")]
    private static partial Regex Type();

    // const float Period = 2; and #define PERIOD 2.0
    [GeneratedRegex(
        @"\bconst\s+(?:float|half|fixed|min16float|min10float)[1-4]?\s+(?<name>\w+)"
        + @"|^[ \t]*#[ \t]*define[ \t]+(?<name>\w+)[ \t]+[-+]?(?:\d+\.\d*|\.\d+|\d+(?=[eEfFhH]))(?:[eE][-+]?\d+)?[fFhH]?[ \t]*\r?$",
        RegexOptions.Multiline)]
    private static partial Regex Constant();

    [GeneratedRegex(@"\b(?:int|uint|bool|dword)[1-4]?\s+(\w+)")]
    private static partial Regex Integer();
}
