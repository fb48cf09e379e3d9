namespace Headless.Shaders.Preprocessing;

/// <summary>Replaces the macros of a condition, as a C preprocessor does; <c>defined X</c> becomes 1 or 0.</summary>
/// <param name="budget">Tokens that may be read, for texts that were written to take long.</param>
internal sealed class MacroExpansion(MacroTable macros, int budget)
{
    private const int MostNested = 100;

    private int _depth;

    /// <param name="Cases">For a number that differs from variant to variant; the text tells such numbers apart.</param>
    internal readonly record struct Token(string Text, Cases? Cases = null)
    {
        public Hidden? Hidden { get; init; }
    }

    /// <summary>Names that are not replaced again in what came from them.</summary>
    internal sealed record Hidden(string Name, Hidden? Next);

    private int _spent;
    private int _numbers;

    /// <summary>Tokens without macros; null where they cannot be told.</summary>
    public List<Token>? Expand(IReadOnlyList<string> tokens) => Expand(tokens.Select(t => new Token(t)));

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
            if (++_spent > budget) return null;
            if (!DirectiveTokens.IsName(token.Text) || Contains(token.Hidden, token.Text))
            {
                result.Add(token);
            }
            else if (token.Text == "defined")
            {
                if (Operand(input) is not { } name) return null;
                result.Add(Number(name, Cases.Truth(macros.Decisions, macros.IsDefined(name))));
            }
            else
            {
                bool called = input.TryPeek(out Token next) && next.Text == "(";
                switch (macros.Only(token.Text))
                {
                    case { Defined: false }:
                        result.Add(token);
                        break;
                    case { Body: { } body } when body.Parameters is not null && !called:
                        result.Add(token);
                        break;
                    case { Body: { } body }:
                        if (!Replace(body, token, input)) return null;
                        break;
                    default:
                        if (called) return null;
                        result.Add(Number(token.Text, Values(token.Text)));
                        break;
                }
            }
        }
        return result;
    }

    // Numbers of one text are the same number.
    private Token Number(string name, Cases cases) => new(
        "?" + (cases.IsKnown ? string.Join('|', cases.All) : macros.IsInitial(name) ? name : $"{++_numbers}"), cases);

    // What a name stands for is a number in each case; one that is not defined is 0.
    private Cases Values(string name)
    {
        List<(int, int)> values = [];
        foreach ((int condition, Macro macro) in macros[name])
        {
            if ((macro.Defined ? macro.Body is { Parameters: null } body ? Condition.Number(body.Text) : null : 0) is not { } value) return Cases.Unknown;
            values.Add((condition, value));
        }
        return Cases.Merge(macros.Decisions, values);
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
        List<Token> replacement = [.. body.Tokens.Select(t => new Token(t) { Hidden = hidden })];
        if (body.Parameters is not null && (Arguments(body, input) is not { } arguments || !Substitute(replacement, arguments, hidden))) return false;
        if (!Paste(replacement)) return false;
        _spent += replacement.Count;
        if (_spent > budget) return false;
        for (int i = replacement.Count - 1; i >= 0; i--) input.Push(replacement[i]);
        return true;
    }

    private Dictionary<string, List<Token>>? Arguments(MacroBody body, Stack<Token> input)
    {
        List<List<Token>> arguments = [[]];
        int depth = 0;
        while (input.TryPop(out Token token))
        {
            if (++_spent > budget) return null;
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
            _spent += put.Count;
            if (_spent > budget) return false;
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
            _spent++;
            if (hidden.Name == name) return true;
        }
        return false;
    }
}
