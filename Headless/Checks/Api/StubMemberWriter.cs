using System.Text;

namespace Headless.Checks.Api;

/// <summary>Writes signature-only members of one type.</summary>
internal sealed class StubMemberWriter(StringBuilder output, ApiTypeNode owner, string kind)
{
    private static readonly Dictionary<string, string> operators = new()
    {
        ["op_Addition"] = "+", ["op_Subtraction"] = "-", ["op_Multiply"] = "*", ["op_Division"] = "/", ["op_Modulus"] = "%",
        ["op_Equality"] = "==", ["op_Inequality"] = "!=", ["op_LessThan"] = "<", ["op_GreaterThan"] = ">",
        ["op_LessThanOrEqual"] = "<=", ["op_GreaterThanOrEqual"] = ">=", ["op_UnaryNegation"] = "-", ["op_UnaryPlus"] = "+",
        ["op_LogicalNot"] = "!", ["op_OnesComplement"] = "~", ["op_BitwiseAnd"] = "&", ["op_BitwiseOr"] = "|", ["op_ExclusiveOr"] = "^",
        ["op_LeftShift"] = "<<", ["op_RightShift"] = ">>", ["op_Increment"] = "++", ["op_Decrement"] = "--", ["op_True"] = "true", ["op_False"] = "false",
    };

    public void Write(ApiEntry member)
    {
        switch (member.Kind)
        {
            case 'F': WriteField(member); break;
            case 'P': WriteProperty(member); break;
            case 'E': output.Append($"{Modifiers(member)} event {TypeSyntax.FromSource(member.ReturnType)} {Name(member)}{(IsAbstract(member) ? ";" : " { add => throw null; remove => throw null; }")}\n"); break;
            case 'M': WriteMethod(member); break;
        }
    }

    private void WriteField(ApiEntry member)
    {
        var type = TypeSyntax.FromSource(member.ReturnType);
        var constant = member.Has("const");
        var modifiers = Modifiers(member) + (constant ? " const" : member.Has("readonly") ? " readonly" : "");
        output.Append($"{modifiers} {type} {Name(member)}{(constant ? " = default" : "")};\n");
    }

    private void WriteProperty(ApiEntry member)
    {
        var open = member.Rest.LastIndexOf('{');
        var accessors = member.Rest[(open + 1)..member.Rest.IndexOf('}', open)];
        var body = new StringBuilder();
        foreach (var part in accessors.Split(';', StringSplitOptions.RemoveEmptyEntries))
            body.Append(part.Trim()).Append(IsAbstract(member) ? "; " : " => throw null; ");
        var type = TypeSyntax.FromSource(member.ReturnType);
        var name = Name(member);
        if (member.Id.Contains('('))
        {
            var (_, parameters) = Parameters(member, owner.TypeParameters, []);
            name = $"this[{parameters}]";
        }
        output.Append($"{Modifiers(member)} {type} {name} {{ {body}}}\n");
    }

    private void WriteMethod(ApiEntry member)
    {
        var name = Name(member);
        var methodParameters = MethodParameters(member);
        var (_, parameters) = Parameters(member, owner.TypeParameters, methodParameters);
        var body = IsAbstract(member) ? ";" : " => throw null;";
        if (name == "#ctor") { output.Append($"{Modifiers(member)} {TypeSyntax.Escape(owner.Name)}({parameters}){body}\n"); return; }
        var type = TypeSyntax.FromSource(member.ReturnType);
        if (name is "op_Implicit" or "op_Explicit")
        {
            output.Append($"public static {(name == "op_Implicit" ? "implicit" : "explicit")} operator {type}({parameters}){body}\n");
            return;
        }
        if (operators.TryGetValue(name, out var symbol)) { output.Append($"public static {type} operator {symbol}({parameters}){body}\n"); return; }
        var generic = methodParameters.Length == 0 ? "" : "<" + string.Join(",", methodParameters) + ">";
        var constraints = member.Has("override") ? "" : string.Concat(member.Constraints.Select(c =>
            $" where {c.Name}:{string.Join(",", TypeSyntax.SplitParameters(c.Constraint).Select(TypeSyntax.FromSource))}"));
        output.Append($"{Modifiers(member)} {type} {TypeSyntax.Escape(name)}{generic}({parameters}){constraints}{body}\n");
    }

    private string[] MethodParameters(ApiEntry member)
    {
        var head = member.Id.IndexOf('(') is var paren and >= 0 ? member.Id[..paren] : member.Id;
        var tick = head.IndexOf("``", StringComparison.Ordinal);
        if (tick < 0) return [];
        var count = int.Parse(head[(tick + 2)..].Split('~')[0]);
        var names = member.Constraints.Select(c => c.Name).Concat(TypeSyntax.FreeNames(member.ReturnType))
            .Where(n => !owner.TypeParameters.Contains(n)).Distinct().Take(count).ToList();
        for (var i = names.Count; i < count; i++) names.Add($"TMethod{i}");
        return [.. names];
    }

    /// <summary>Parameter list in C#, for example <c>in global::UnityEngine.RenderParams rparams, int count = default</c>.</summary>
    public static (int Count, string Source) Parameters(ApiEntry member, IReadOnlyList<string> typeParameters, IReadOnlyList<string> methodParameters)
    {
        var open = member.Id.IndexOf('(');
        if (open < 0) return (0, "");
        var close = member.Id.LastIndexOf(')');
        var types = TypeSyntax.SplitParameters(member.Id[(open + 1)..close]);
        var names = member.ParameterNames;
        var parts = new string[types.Count];
        for (var i = 0; i < types.Count; i++)
        {
            var words = i < names.Length ? names[i].Trim().Split(' ') : [$"p{i}"];
            var name = words[^1];
            var optional = name.EndsWith('?');
            var modifiers = string.Join(' ', words[..^1]);
            if (types[i].EndsWith('@') && !modifiers.Contains("in") && !modifiers.Contains("out") && !modifiers.Contains("ref")) modifiers += " ref";
            var type = TypeSyntax.FromDocumentationId(types[i], typeParameters, methodParameters);
            parts[i] = $"{modifiers} {type} {TypeSyntax.Escape(name.TrimEnd('?'))}{(optional ? " = default" : "")}".Trim();
        }
        return (parts.Length, string.Join(", ", parts));
    }

    private bool IsAbstract(ApiEntry member) => kind == "interface" || member.Has("abstract");

    private string Modifiers(ApiEntry member)
    {
        if (kind == "interface") return "";
        var words = new List<string> { member.Has("protected") ? "protected" : "public" };
        foreach (var word in new[] { "static", "abstract", "virtual", "sealed", "override" })
            if (Head(member).Contains(word)) words.Add(word);
        if (words.Contains("virtual") && kind.Contains("struct")) words.Remove("virtual");
        return string.Join(' ', words);
    }

    private static string[] Head(ApiEntry member)
    {
        var arrow = member.Rest.IndexOf("->", StringComparison.Ordinal);
        return (arrow < 0 ? member.Rest : member.Rest[..arrow]).Split(' ', StringSplitOptions.RemoveEmptyEntries);
    }

    private static string Name(ApiEntry member)
    {
        var head = member.Id.IndexOf('(') is var paren and >= 0 ? member.Id[..paren] : member.Id;
        head = head.Split('~')[0];
        var name = head[(head.LastIndexOf('.') + 1)..];
        return name.Split("``")[0] is { } plain && plain == "#ctor" ? plain : TypeSyntax.Escape(name.Split("``")[0]);
    }
}
