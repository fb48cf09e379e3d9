namespace Headless.Shaders.Preprocessing;

/// <summary>Replaces the macros of a condition, as a C preprocessor does; <c>defined X</c> becomes 1 or 0.</summary>
/// <param name="budget">Tokens that may be read, for texts that were written to take long.</param>
internal sealed class MacroExpansion(MacroTable macros, int budget)
{
    /// <summary>Stands for a value that depends on the variant.</summary>
    public const string Unknown = "?";

    private const int MostNested = 100;

    private int _depth;

    private readonly record struct Token(string Text, Hidden? Hidden);

    /// <summary>Names that are not replaced again in what came from them.</summary>
    private sealed record Hidden(string Name, Hidden? Next);

    /// <summary>Tokens read so far.</summary>
    public int Spent { get; private set; }

    /// <summary>Tokens without macros, <see cref="Unknown"/> among them; null where more cannot be said.</summary>
    public List<string>? Expand(IReadOnlyList<string> tokens) => Expand(tokens.Select(t => new Token(t, null)))?.ConvertAll(t => t.Text);

    // Arguments of calls within arguments.
    private List<Token>? Expand(IEnumerable<Token> tokens)
    {
        if (_depth >= MostNested) return null;
        _depth++;
        List<Token>? result = Replaced(tokens);
        _depth--;
        return result;
    }

    private List<Token>? Replaced(IEnumerable<Token> tokens)
    {
        List<Token> result = [];
        Stack<Token> input = new(tokens.Reverse());
        while (input.TryPop(out Token token))
        {
            if (++Spent > budget) return null;
            if (!DirectiveTokens.IsName(token.Text) || Contains(token.Hidden, token.Text))
            {
                result.Add(token);
            }
            else if (token.Text == "defined")
            {
                if (Operand(input) is not { } name) return null;
                result.Add(new Token(macros[name].Defined switch { true => "1", false => "0", null => Unknown }, null));
            }
            else if (macros[token.Text] is { Defined: not false } macro)
            {
                bool called = input.TryPeek(out Token next) && next.Text == "(";
                if (macro.Body is not { } body)
                {
                    if (called) return null;
                    result.Add(new Token(Unknown, null));
                }
                else if (body.Parameters is not null && !called)
                {
                    result.Add(token);
                }
                else if (!Replace(body, token, input))
                {
                    return null;
                }
            }
            else
            {
                result.Add(token);
            }
        }
        return result;
    }

    // defined X and defined(X)
    private static string? Operand(Stack<Token> input)
    {
        if (!input.TryPop(out Token token)) return null;
        if (token.Text != "(") return DirectiveTokens.IsName(token.Text) ? token.Text : null;
        return input.TryPop(out Token name) && DirectiveTokens.IsName(name.Text) && input.TryPop(out Token close) && close.Text == ")" ? name.Text : null;
    }

    private bool Replace(MacroBody body, Token name, Stack<Token> input)
    {
        Hidden hidden = new(name.Text, name.Hidden);
        List<Token> replacement = [.. body.Tokens.Select(t => new Token(t, hidden))];
        if (body.Parameters is not null && (Arguments(body, input) is not { } arguments || !Substitute(replacement, arguments, hidden))) return false;
        if (!Paste(replacement)) return false;
        Spent += replacement.Count;
        if (Spent > budget) return false;
        for (int i = replacement.Count - 1; i >= 0; i--) input.Push(replacement[i]);
        return true;
    }

    private Dictionary<string, List<Token>>? Arguments(MacroBody body, Stack<Token> input)
    {
        List<List<Token>> arguments = [[]];
        int depth = 0;
        while (input.TryPop(out Token token))
        {
            if (++Spent > budget) return null;
            depth += token.Text == "(" ? 1 : token.Text == ")" ? -1 : 0;
            if (depth == 0)
            {
                string[] names = body.ParameterNames;
                if (names.Length == 0 && arguments is [{ Count: 0 }]) return [];
                return names.Length == arguments.Count && names.Distinct().Count() == names.Length
                    ? names.Zip(arguments).ToDictionary(p => p.First, p => p.Second)
                    : null;
            }
            if (depth == 1 && token.Text == "(") continue;
            if (depth == 1 && token.Text == ",") arguments.Add([]);
            else arguments[^1].Add(token);
        }
        return null;
    }

    // An argument beside ## is pasted as it was written; elsewhere its own macros are replaced first.
    private bool Substitute(List<Token> body, Dictionary<string, List<Token>> arguments, Hidden hidden)
    {
        List<Token> result = [];
        for (int i = 0; i < body.Count; i++)
        {
            if (body[i].Text == "#") return false;
            if (!arguments.TryGetValue(body[i].Text, out List<Token>? argument))
            {
                result.Add(body[i]);
                continue;
            }
            bool pasted = (i > 0 && body[i - 1].Text == "##") || (i + 1 < body.Count && body[i + 1].Text == "##");
            List<Token>? put = pasted ? argument : Expand(argument);
            if (put is null) return false;
            result.AddRange(put.Select(t => t.Hidden is null ? t with { Hidden = hidden } : t));
            Spent += put.Count;
            if (Spent > budget) return false;
        }
        body.Clear();
        body.AddRange(result);
        return true;
    }

    private static bool Paste(List<Token> tokens)
    {
        for (int i = tokens.FindIndex(t => t.Text == "##"); i >= 0; i = tokens.FindIndex(t => t.Text == "##"))
        {
            if (i == 0 || i + 1 == tokens.Count) return false;
            tokens[i - 1] = tokens[i - 1] with { Text = tokens[i - 1].Text + tokens[i + 1].Text };
            tokens.RemoveRange(i, 2);
        }
        return true;
    }

    private bool Contains(Hidden? hidden, string name)
    {
        for (; hidden is not null; hidden = hidden.Next)
        {
            Spent++;
            if (hidden.Name == name) return true;
        }
        return false;
    }
}
