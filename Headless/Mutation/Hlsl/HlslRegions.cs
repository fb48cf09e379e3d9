namespace Headless.Mutation.Hlsl;

/// <summary>Which tokens are code: those of function bodies and of initial values, less attributes. Declarations are not.</summary>
internal static class HlslRegions
{
    private static readonly HashSet<string> Attributes = ["numthreads", "unroll", "loop", "branch", "flatten", "fastopt", "allow_uav_condition", "maxvertexcount"];

    public static bool[] Code(IReadOnlyList<HlslToken> tokens)
    {
        var code = new bool[tokens.Count];
        Stack<bool> blocks = [];
        bool value = false;
        for (int i = 0; i < tokens.Count; i++)
        {
            HlslToken token = tokens[i];
            bool inside = blocks.Count > 0 ? blocks.Peek() : value;
            if (token.Is("[") && i + 1 < tokens.Count && Attributes.Contains(tokens[i + 1].Text))
            {
                while (i < tokens.Count && !tokens[i].Is("]")) i++;
                continue;
            }
            if (token.Is("{"))
            {
                blocks.Push(inside || OpensBody(tokens, i));
                continue;
            }
            if (token.Is("}"))
            {
                if (blocks.Count > 0) blocks.Pop();
                continue;
            }
            if (blocks.Count == 0)
            {
                if (token.Is("=")) { value = true; continue; }
                if (token.Is(";")) value = false;
            }
            code[i] = inside;
        }
        return code;
    }

    // "f(...) {" and "f(...) : SV_Target {", not "struct S {" or "cbuffer C : register(b0) {".
    private static bool OpensBody(IReadOnlyList<HlslToken> tokens, int brace)
    {
        bool closed = false;
        for (int i = brace - 1; i >= 0 && !tokens[i].Is(";") && !tokens[i].Is("}") && !tokens[i].Is("{"); i--)
        {
            if (tokens[i].Text is "struct" or "cbuffer" or "tbuffer" or "CBUFFER_START") return false;
            closed |= tokens[i].Is(")");
        }
        return closed;
    }
}
