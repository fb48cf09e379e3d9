namespace Headless.Checks.Api;

/// <summary>One line of an API list, for example
/// <c>M:UnityEngine.Debug.Log(System.Object) static -> System.Void (message)</c>.</summary>
internal sealed record ApiEntry(char Kind, string Id, string Rest)
{
    public static ApiEntry Parse(string line)
    {
        var space = line.IndexOf(' ');
        var id = space < 0 ? line : line[..space];
        return new ApiEntry(id[0], id[2..], space < 0 ? "" : line[(space + 1)..]);
    }

    /// <summary>Its name without namespace, type, number of type parameters and parameters: <c>Log</c>, <c>#ctor</c>, <c>op_Implicit</c>.</summary>
    public string Name { get; } = NameOf(Id);

    private static string NameOf(string id)
    {
        var end = id.AsSpan().IndexOfAny('(', '~');
        if (end < 0) end = id.Length;
        var start = id.LastIndexOf('.', end - 1) + 1;
        var tick = id.IndexOf('`', start);
        return id[start..(tick >= 0 && tick < end ? tick : end)];
    }

    public string DocumentationId => $"{Kind}:{Id}";
    public bool IsExtension => Rest.Contains("(this ", StringComparison.Ordinal);

    /// <summary>All but where it is declared.</summary>
    public string Signature => $"{DocumentationId} {(Module.Length > 0 ? Rest[..Rest.LastIndexOf('@')].TrimEnd() : Rest)}";

    public bool Has(string word) => (" " + Rest + " ").Contains(" " + word + " ", StringComparison.Ordinal);
    public bool IsEditorOnly => Rest.Contains("!editor-only", StringComparison.Ordinal);
    public bool IsObsoleteError => Has("!obsolete-error");
    public bool IsObsolete => IsObsoleteError || Has("!obsolete");

    /// <summary>Name of the declaring assembly after '@' in package lists; the module in engine lists.</summary>
    public string Module => Rest.LastIndexOf('@') is var at && at >= 0 ? Rest[(at + 1)..].Trim() : "";

    /// <summary>Text between "-> " and the next section, for example <c>System.Collections.Generic.List&lt;T&gt;</c>.</summary>
    public string ReturnType
    {
        get
        {
            var start = Rest.StartsWith("-> ", StringComparison.Ordinal) ? 3 : Rest.IndexOf(" -> ", StringComparison.Ordinal) + 4;
            if (start < 3 || (start == 3 && !Rest.StartsWith("-> ", StringComparison.Ordinal))) return "";
            return Rest[start..EndOfType(start)];
        }
    }

    private int EndOfType(int start)
    {
        var depth = 0;
        foreach (var prefix in new[] { "ref ", "readonly " })
            if (string.CompareOrdinal(Rest, start, prefix, 0, prefix.Length) == 0) start += prefix.Length;
        for (var i = start; i < Rest.Length; i++)
        {
            if (Rest[i] is '<' or '(') depth++;
            else if (Rest[i] is '>' or ')') depth--;
            else if (Rest[i] == ' ' && depth == 0) return i;
        }
        return Rest.Length;
    }

    /// <summary>Parameter names with modifiers, for example <c>["in rparams", "topology", "instanceCount?"]</c>.</summary>
    public string[] ParameterNames
    {
        get
        {
            var open = Rest.IndexOf(" (", StringComparison.Ordinal);
            if (Rest.StartsWith('(')) open = -1;
            else if (open < 0) return [];
            var close = Rest.IndexOf(')', open + 1);
            var inner = Rest[(open + 2)..close];
            return inner.Length == 0 ? [] : inner.Split(',');
        }
    }

    /// <summary>Constraint clauses: type-parameter name and its constraint.</summary>
    public (string Name, string Constraint)[] Constraints =>
        System.Text.RegularExpressions.Regex.Matches(Rest, @"where (\w+):(\S+)")
            .Select(m => (m.Groups[1].Value, m.Groups[2].Value)).ToArray();
}
