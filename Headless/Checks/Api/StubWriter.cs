using System.Text;

namespace Headless.Checks.Api;

/// <summary>Writes signature-only C# source for the types of an API list.</summary>
/// <param name="output">Receives it.</param>
/// <param name="diagnosticOf">The compiler message that a use of an entry gets beside those of the list; null for none.</param>
internal sealed class StubWriter(StringBuilder output, Func<ApiTypeNode, ApiEntry, string?> diagnosticOf)
{
    /// <summary>Types that are reached, with their reached members, and all namespaces.</summary>
    public static string Write(IEnumerable<ApiTypeNode> roots, Func<ApiTypeNode, ApiEntry, string?> diagnosticOf)
    {
        var text = new StringBuilder("#pragma warning disable\n");
        var writer = new StubWriter(text, diagnosticOf);
        foreach (var group in roots.GroupBy(r => r.Namespace))
        {
            if (group.Key.Length > 0) text.Append("namespace ").Append(group.Key).Append(" {\n");
            foreach (var node in group.Where(n => n.Reached is not null)) writer.WriteType(node);
            if (group.Key.Length > 0) text.Append("}\n");
        }
        return text.ToString();
    }

    private void WriteType(ApiTypeNode node)
    {
        WriteAttributes(node, node.Entry);
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
        if (kind == "enum") foreach (var member in node.Reached!.Where(m => m.Kind == 'F')) WriteEnumMember(node, member);
        else
        {
            var members = new StubMemberWriter(output, node, kind);
            foreach (var member in node.Reached!) { WriteAttributes(node, member); members.Write(member); }
        }
        foreach (var nested in node.Nested.Where(n => n.Reached is not null)) WriteType(nested);
        output.Append("}\n");
    }

    private void WriteEnumMember(ApiTypeNode node, ApiEntry member)
    {
        WriteAttributes(node, member);
        output.Append(TypeSyntax.Escape(member.Id[(member.Id.LastIndexOf('.') + 1)..])).Append(",\n");
    }

    private void WriteDelegate(ApiTypeNode node, string access, string generic, string constraints)
    {
        if (node.Members.FirstOrDefault(m => m.Id.Contains(".Invoke")) is not { } invoke) return;
        var (_, parameters) = StubMemberWriter.Parameters(invoke, node.TypeParameters, []);
        output.Append($"{access} unsafe delegate {TypeSyntax.FromSource(invoke.ReturnType)} {node.Name}{generic}({parameters}){constraints};\n");
    }

    private void WriteAttributes(ApiTypeNode node, ApiEntry entry)
    {
        if (diagnosticOf(node, entry) is { } diagnostic) output.Append($"[global::System.Diagnostics.CodeAnalysis.Experimental(\"{diagnostic}\")] ");
        if (entry.IsObsolete) output.Append($"[global::System.Obsolete(\"obsolete\", {(entry.IsObsoleteError ? "true" : "false")})] ");
    }

    private static string Kind(ApiEntry entry)
    {
        var words = entry.Rest.Split(' ');
        foreach (var kind in new[] { "interface", "enum", "struct", "class" })
            if (words.Contains(kind))
                return kind is "class" && words[0] is "static" or "abstract" or "sealed" ? $"{words[0]} class"
                    : kind is "struct" && words.Contains("ref") ? "ref struct" : kind;
        return "class";
    }

    private static string ConstraintSource(string constraint) => string.Join(",", TypeSyntax.SplitParameters(constraint).Select(TypeSyntax.FromSource));
}
