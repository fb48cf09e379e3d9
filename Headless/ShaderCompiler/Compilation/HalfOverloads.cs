using System.Text.RegularExpressions;

namespace Headless.Shaders;

/// <summary>
/// Keeps one of the functions that differ in half and float alone: <c>half Luma(half3 c)</c> beside <c>float Luma(float3 c)</c>.
/// </summary>
/// <remarks>
/// Direct3D 11 on a desktop works out half and the min16 types with 32 bits, and glslang takes them for float and int, so that such
/// functions have one signature. The one that is written with the full types is kept, else the first. FXC also calls that one for
/// min16float; for half it calls the other, which is not told apart here.
/// </remarks>
internal static partial class HalfOverloads
{
    private readonly record struct Function(int First, int Brace, int Last, string Written, string Signature);

    /// <param name="text">Text behind the preprocessor.</param>
    public static string Drop(string text)
    {
        List<HlslToken> tokens = HlslTokens.Read(text);
        TextEdit edit = new(text);
        foreach (IGrouping<string, Function> equal in Functions(tokens).GroupBy(f => f.Signature))
        {
            Function kept = equal.FirstOrDefault(f => f.Written == f.Signature, equal.First());
            foreach (Function function in equal.Where(f => f.Written != kept.Written))
            {
                Drop(function, kept, tokens, edit);
            }
        }
        return edit.ToString();
    }

    // One that comes first stays as a declaration, for calls between the two.
    private static void Drop(Function function, Function kept, List<HlslToken> tokens, TextEdit edit)
    {
        int start = tokens[function.First].Start;
        if (function.First < kept.First)
        {
            start = tokens[function.Brace].End;
            edit.Replace(tokens[function.Brace].Start, 1, ";");
        }
        edit.Blank(start, tokens[function.Last].End);
    }

    private static IEnumerable<Function> Functions(List<HlslToken> tokens)
    {
        int first = 0;
        for (int i = 0; i < tokens.Count; i++)
        {
            if (tokens[i].Braces > 0 || tokens[i].Parentheses > 0)
            {
                continue;
            }
            if (tokens[i].Text is ";" or "}")
            {
                first = i + 1;
            }
            else if (tokens[i].Text == "{")
            {
                int last = tokens.FindIndex(i, t => t is { Text: "}", Braces: 0 });
                if (last < 0)
                {
                    yield break;
                }
                if (Signature(tokens, first, i) is { } signature)
                {
                    yield return new Function(first, i, last, signature, Full(signature));
                }
                i = last;
                first = i + 1;
            }
        }
    }

    /// <summary>"Luma(half3)" of "half Luma(half3 c)"; null where a structure or a buffer begins.</summary>
    private static string? Signature(List<HlslToken> tokens, int first, int brace)
    {
        int open = tokens.FindIndex(first, brace - first, t => t is { Text: "(", Parentheses: 0 });
        if (open <= first + 1 || !tokens[open - 1].IsWord || !tokens[open - 2].IsWord)
        {
            return null;
        }
        int close = tokens.FindIndex(open, brace - open, t => t is { Text: ")", Parentheses: 0 });
        if (close < 0)
        {
            return null;
        }
        List<string> types = [];
        for (int at = open + 1; at < close;)
        {
            int end = tokens.FindIndex(at, close - at, t => t is { Text: ",", Parentheses: 1 });
            end = end < 0 ? close : end;
            types.Add(Type(tokens.GetRange(at, end - at)));
            at = end + 1;
        }
        return $"{tokens[open - 1].Text}({string.Join(',', types)})";
    }

    // "half3[2]" of "in const half3 c[2] : COLOR = 0": words before the name, without what does not tell overloads apart.
    private static string Type(List<HlslToken> parameter)
    {
        int end = parameter.FindIndex(t => t.Text is ":" or "=");
        List<string> words = [.. (end < 0 ? parameter : parameter.GetRange(0, end)).Select(t => t.Text).Where(w => !Modifiers.Contains(w))];
        int array = words.IndexOf("[");
        int name = (array < 0 ? words.Count : array) - 1;
        if (name > 0 && words[name] != ">")
        {
            words.RemoveAt(name);
        }
        return string.Concat(words);
    }

    private static string Full(string signature)
    {
        int open = signature.IndexOf('(', StringComparison.Ordinal);
        return signature[..open] + Reduced().Replace(signature[open..], m => m.Groups["type"].Value switch
        {
            "min16int" or "min12int" => "int",
            "min16uint" => "uint",
            _ => "float",
        } + m.Groups["size"].Value);
    }

    private static readonly HashSet<string> Modifiers =
        ["in", "out", "inout", "const", "uniform", "precise", "linear", "centroid", "nointerpolation", "noperspective", "sample", "row_major", "column_major"];

    [GeneratedRegex(@"\b(?<type>half|min16float|min10float|min16int|min12int|min16uint)(?<size>[1-4]?(?:x[1-4])?)\b")]
    private static partial Regex Reduced();
}
