using System.Text;

namespace Headless.Checks.Api;

/// <summary>Writes signature-only C# source for the types of an API list.</summary>
internal sealed class StubWriter(StringBuilder output)
{
    public static string Write(IEnumerable<ApiTypeNode> roots)
    {
        var text = new StringBuilder("#pragma warning disable\n");
        var writer = new StubWriter(text);
        foreach (var group in roots.GroupBy(r => r.Namespace))
        {
            if (group.Key.Length > 0) text.Append("namespace ").Append(group.Key).Append(" {\n");
            foreach (var node in group) writer.WriteType(node);
            if (group.Key.Length > 0) text.Append("}\n");
        }
        return text.ToString();
    }

    private void WriteType(ApiTypeNode node)
    {
        WriteObsolete(node.Entry);
        var access = node.Entry.Has("protected") ? "protected" : "public";
        var generic = node.Arity == 0 ? "" : "<" + string.Join(",", node.OwnParameters) + ">";
        var constraints = string.Concat(node.Entry.Constraints.Select(c => $" where {c.Name}:{ConstraintSource(c.Constraint)}"));
        if (node.Entry.Has("delegate")) { WriteDelegate(node, access, generic, constraints); return; }
        var kind = Kind(node.Entry);
        var bases = string.Join(", ", TypeSyntax.SplitParameters(node.BaseList).Select(b => TypeSyntax.FromSource(b.Trim())));
        if (kind == "enum") bases = bases switch
        {
            "global::System.Byte" => "byte",
            "global::System.SByte" => "sbyte",
            "global::System.Int16" => "short",
            "global::System.UInt16" => "ushort",
            "global::System.UInt32" => "uint",
            "global::System.Int64" => "long",
            "global::System.UInt64" => "ulong",
            _ => "int",
        };
        if (bases is "global::System.Attribute") output.Append("[global::System.AttributeUsage(global::System.AttributeTargets.All, AllowMultiple = true)] ");
        output.Append(access).Append(kind == "enum" ? " enum " : $" unsafe {kind} ").Append(TypeSyntax.Escape(node.Name)).Append(generic);
        if (bases.Length > 0) output.Append(" : ").Append(bases);
        output.Append(constraints).Append(" {\n");
        if (kind == "enum") foreach (var member in node.Members.Where(m => m.Kind == 'F')) WriteEnumMember(member);
        else
        {
            var members = new StubMemberWriter(output, node, kind);
            foreach (var member in node.Members) { WriteObsolete(member); members.Write(member); }
        }
        foreach (var nested in node.Nested) WriteType(nested);
        output.Append("}\n");
    }

    private void WriteEnumMember(ApiEntry member)
    {
        WriteObsolete(member);
        output.Append(TypeSyntax.Escape(member.Id[(member.Id.LastIndexOf('.') + 1)..])).Append(",\n");
    }

    private void WriteDelegate(ApiTypeNode node, string access, string generic, string constraints)
    {
        if (node.Members.FirstOrDefault(m => m.Id.Contains(".Invoke")) is not { } invoke) return;
        var (_, parameters) = StubMemberWriter.Parameters(invoke, node.TypeParameters, []);
        output.Append($"{access} unsafe delegate {TypeSyntax.FromSource(invoke.ReturnType)} {node.Name}{generic}({parameters}){constraints};\n");
    }

    private void WriteObsolete(ApiEntry entry)
    {
        if (entry.IsObsolete) output.Append($"[global::System.Obsolete(\"obsolete\", {(entry.IsObsoleteError ? "true" : "false")})] ");
    }

    private static string Kind(ApiEntry entry)
    {
        var words = entry.Rest.Split(' ');
        foreach (var kind in new[] { "interface", "enum", "struct", "class" })
            if (words.Contains(kind))
                return kind is "class" && words[0] is "static" or "abstract" or "sealed" ? $"{words[0]} class"
                    : kind is "struct" && words[0] is "readonly" or "ref" ? (words[0] == "ref" ? "ref struct" : "struct") : kind;
        return "class";
    }

    private static string ConstraintSource(string constraint) => string.Join(",", TypeSyntax.SplitParameters(constraint).Select(TypeSyntax.FromSource));
}
