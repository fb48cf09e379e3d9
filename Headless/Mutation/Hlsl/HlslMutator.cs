namespace Headless.Mutation.Hlsl;

/// <summary>Every change that it knows of the code of an HLSL file. Headers of for loops keep their counting: it would only run without end.</summary>
internal sealed class HlslMutator
{
    private static readonly Dictionary<string, string> Binary = new()
    {
        ["+"] = "-", ["-"] = "+", ["*"] = "/", ["/"] = "*", ["%"] = "/", ["<<"] = ">>", [">>"] = "<<", ["&"] = "|", ["|"] = "&", ["^"] = "|",
    };

    private static readonly Dictionary<string, string> Assignments = new()
    {
        ["+="] = "-=", ["-="] = "+=", ["*="] = "/=", ["/="] = "*=", ["|="] = "&=", ["&="] = "|=", ["++"] = "--", ["--"] = "++",
    };

    private static readonly Dictionary<string, string> Boundaries = new()
    {
        ["<"] = "<=", ["<="] = "<", [">"] = ">=", [">="] = ">", ["=="] = "!=", ["!="] = "==",
    };

    private static readonly Dictionary<string, string> Swaps = new()
    {
        ["min"] = "max", ["max"] = "min", ["InterlockedMin"] = "InterlockedMax", ["InterlockedMax"] = "InterlockedMin",
    };

    private static readonly HashSet<string> TermEnds =
        ["+", "-", ",", ";", ")", "]", "}", "?", ":", "<", ">", "<=", ">=", "==", "!=", "&&", "||", "&", "|", "^", "<<", ">>"];

    private readonly string file;
    private readonly string text;
    private readonly List<HlslToken> tokens;
    private readonly List<Mutant> found = [];

    private HlslMutator(string file, string text)
    {
        (this.file, this.text) = (file, text);
        tokens = HlslLexer.Read(text);
    }

    public static IReadOnlyList<Mutant> Find(string file, string text)
    {
        var mutator = new HlslMutator(file, text);
        bool[] code = HlslRegions.Code(mutator.tokens);
        for (int i = 1; i < code.Length - 1; i++)
            if (code[i]) mutator.Visit(i);
        return mutator.found;
    }

    private void Visit(int i)
    {
        HlslToken token = tokens[i];
        if (token.Kind == HlslTokenKind.Number)
        {
            if (Constants.Other(token.Text) is { } other) Replace("constant", i, other);
        }
        else if (token.Kind == HlslTokenKind.Name) VisitName(i);
        else VisitSymbol(i);
        if (BeginsStatement(i)) DeleteStatement(i);
    }

    private void VisitName(int i)
    {
        HlslToken token = tokens[i];
        if (tokens[i - 1].Is(".") && IsSwizzle(token.Text)) Replace("swizzle", i, Turned(token.Text));
        if (!tokens[i + 1].Is("(")) return;
        if (Swaps.TryGetValue(token.Text, out string? swapped)) Replace("min/max", i, swapped);
        else if (token.Text is "saturate" or "abs" or "floor" or "ceil" or "round") Remove("drop function", token.Start, token.End);
        else if (token.Text == "clamp" && Matching(i + 1) is { } close && FirstComma(i + 1) is { } comma)
            Add("drop function", token.Start, tokens[close].End, text[tokens[i + 1].Start..tokens[comma].Start] + ")");
        else if (token.Text == "if" && Matching(i + 1) is { } end)
            Add("condition", tokens[i + 1].Start, tokens[end].End, "(!" + text[tokens[i + 1].Start..tokens[end].End] + ")");
    }

    private void VisitSymbol(int i)
    {
        string symbol = tokens[i].Text;
        bool counting = InForHeader(i);
        if (Boundaries.TryGetValue(symbol, out string? boundary)) Replace("relational", i, boundary);
        else if (symbol is "&&" or "||") Replace("logical", i, symbol == "&&" ? "||" : "&&");
        else if (symbol == "!") Remove("condition", tokens[i].Start, tokens[i].End);
        else if (Assignments.TryGetValue(symbol, out string? assignment) && !counting) Replace("arithmetic", i, assignment);
        else if (Binary.TryGetValue(symbol, out string? other))
        {
            if (!EndsOperand(tokens[i - 1]))
            {
                if (symbol == "-") Remove("sign", tokens[i].Start, tokens[i].End);
                return;
            }
            Replace("arithmetic", i, other);
            if (symbol is "+" or "-" && EndOfTerm(i + 1) is { } end) Remove("term", tokens[i].Start, end);
        }
    }

    private void DeleteStatement(int i)
    {
        if (tokens[i].Kind != HlslTokenKind.Name || tokens[i].Text is "return" or "if" or "for" or "while" or "else" or "const" or "do") return;
        int at = i + 1;
        while (at < tokens.Count && (tokens[at].Is(".") || tokens[at].Is("[") || (tokens[at].Kind == HlslTokenKind.Name && tokens[at - 1].Is("."))))
            at = tokens[at].Is("[") && Matching(at) is { } close ? close + 1 : at + 1;
        if (at >= tokens.Count) return;
        bool assigns = tokens[at].Text is "=" or "+=" or "-=" or "*=" or "/=" or "|=" or "&=" or "^=" or "++" or "--";
        bool calls = tokens[at].Is("(") && at == i + 1 && Matching(at) is { } end && tokens[end + 1].Is(";");
        if (!assigns && !calls) return;
        int last = at;
        while (last < tokens.Count && !tokens[last].Is(";"))
        {
            if (tokens[last].Is("{")) return;
            last++;
        }
        if (last < tokens.Count) Add("statement", tokens[i].Start, tokens[last].End, ";");
    }

    private bool BeginsStatement(int i) => tokens[i - 1].Is(";") && !InForHeader(i) || tokens[i - 1].Is("{") || tokens[i - 1].Is("}");

    private bool InForHeader(int i)
    {
        int depth = 0;
        for (int k = i - 1; k > 0 && !tokens[k].Is("{") && !tokens[k].Is("}"); k--)
        {
            if (tokens[k].Is(")")) depth++;
            else if (tokens[k].Is("(") && --depth < 0)
            {
                if (tokens[k - 1].Is("for")) return true;
                depth = 0;
            }
        }
        return false;
    }

    private int? EndOfTerm(int from)
    {
        int depth = 0;
        for (int i = from; i < tokens.Count; i++)
        {
            HlslToken token = tokens[i];
            if (depth == 0 && i > from && TermEnds.Contains(token.Text) && EndsOperand(tokens[i - 1])) return tokens[i - 1].End;
            if (token.Text is "(" or "[") depth++;
            if (token.Text is ")" or "]" && --depth < 0) return null;
            if (token.Text is ";" or "{") return null;
        }
        return null;
    }

    private int? Matching(int open)
    {
        int depth = 0;
        for (int i = open; i < tokens.Count; i++)
        {
            if (tokens[i].Text is "(" or "[") depth++;
            else if (tokens[i].Text is ")" or "]" && --depth == 0) return i;
        }
        return null;
    }

    private int? FirstComma(int open)
    {
        int depth = 0;
        for (int i = open; i < tokens.Count; i++)
        {
            if (tokens[i].Text is "(" or "[") depth++;
            else if (tokens[i].Text is ")" or "]" && --depth == 0) return null;
            else if (tokens[i].Is(",") && depth == 1) return i;
        }
        return null;
    }

    private static bool EndsOperand(HlslToken token) =>
        token.Kind == HlslTokenKind.Number || (token.Kind == HlslTokenKind.Name && token.Text != "return") || token.Text is ")" or "]";

    private static bool IsSwizzle(string name) => name.Length is >= 1 and <= 4 && (name.All("xyzw".Contains) || name.All("rgba".Contains));

    // One component becomes the next, several are turned round: yz -> zy.
    private static string Turned(string swizzle)
    {
        if (swizzle.Length == 1) return swizzle switch { "x" => "y", "r" => "g", "y" or "z" or "w" => "x", _ => "r" };
        string turned = swizzle[1..] + swizzle[0];
        return turned == swizzle ? (swizzle[0] == 'x' ? "y" : "x") + swizzle[1..] : turned;
    }

    private void Replace(string kind, int i, string with) => Add(kind, tokens[i].Start, tokens[i].End, with);

    private void Remove(string kind, int start, int end) => Add(kind, start, end, "");

    private void Add(string kind, int start, int end, string with) => found.Add(Mutant.Create(file, text, kind, start, end - start, with));
}
