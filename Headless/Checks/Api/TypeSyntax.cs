using System.Text;
using System.Text.RegularExpressions;

namespace Headless.Checks.Api;

/// <summary>Turns documentation-id type names into C# source, for example
/// <c>System.Collections.Generic.List{``0}@</c> into <c>ref global::System.Collections.Generic.List&lt;T&gt;</c>.</summary>
internal static partial class TypeSyntax
{
    public static string FromDocumentationId(string id, IReadOnlyList<string> typeParameters, IReadOnlyList<string> methodParameters)
    {
        id = id.TrimEnd('@');
        id = MethodParameter().Replace(id, m => methodParameters[int.Parse(m.Groups[1].Value)]);
        id = TypeParameter().Replace(id, m => typeParameters[int.Parse(m.Groups[1].Value)]);
        id = MultiDimensional().Replace(id, m => "[" + new string(',', m.Value.Count(c => c == ',')) + "]");
        return Qualify(id.Replace('{', '<').Replace('}', '>'));
    }

    public static string FromSource(string source) => Qualify(source);

    private static string Qualify(string type)
    {
        type = DottedName().Replace(type, m => "global::" + string.Join('.', m.Value.Split('.').Select(Escape)));
        return type.Replace("global::System.Void*", "void*").Replace("global::System.Void", "void");
    }

    public static string Escape(string identifier) =>
        Microsoft.CodeAnalysis.CSharp.SyntaxFacts.GetKeywordKind(identifier) != Microsoft.CodeAnalysis.CSharp.SyntaxKind.None
            ? "@" + identifier : identifier;

    /// <summary>Splits <c>A,B{C,D},E[0:,0:]</c> at the top level.</summary>
    public static List<string> SplitParameters(string list)
    {
        var parts = new List<string>();
        var depth = 0;
        var current = new StringBuilder();
        foreach (var c in list)
        {
            if (c is '{' or '[' or '<') depth++;
            if (c is '}' or ']' or '>') depth--;
            if (c == ',' && depth == 0) { parts.Add(current.ToString()); current.Clear(); }
            else current.Append(c);
        }
        if (current.Length > 0) parts.Add(current.ToString());
        return parts;
    }

    /// <summary>Names without a dot in a return type that can only be type parameters: <c>T</c>, <c>TValue</c>.</summary>
    public static IEnumerable<string> FreeNames(string source) =>
        FreeName().Matches(source).Select(m => m.Value).Where(n => n is not ("ref" or "readonly"));

    [GeneratedRegex(@"``(\d+)")] private static partial Regex MethodParameter();
    [GeneratedRegex(@"`(\d+)")] private static partial Regex TypeParameter();
    [GeneratedRegex(@"\[0:(,0:)+\]")] private static partial Regex MultiDimensional();
    [GeneratedRegex(@"(?<![\w.>:])[A-Za-z_]\w*(\.[A-Za-z_]\w*)+")] private static partial Regex DottedName();
    [GeneratedRegex(@"(?<![\w.])[A-Za-z_]\w*(?![\w.])")] private static partial Regex FreeName();
}
