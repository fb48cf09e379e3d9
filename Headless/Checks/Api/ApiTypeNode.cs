namespace Headless.Checks.Api;

/// <summary>A type of an API list with its members and nested types.</summary>
internal sealed class ApiTypeNode(ApiEntry entry, string ns, string name, int arity)
{
    public ApiEntry Entry { get; } = entry;
    public string Namespace { get; } = ns;
    public string Name { get; } = name;
    public int Arity { get; } = arity;
    public ApiTypeNode? Parent { get; set; }
    public List<ApiTypeNode> Nested { get; } = [];
    public List<ApiEntry> Members { get; } = [];

    /// <summary>Members that a stub gets; null where the type gets none itself.</summary>
    public List<ApiEntry>? Reached { get; set; }

    private string[]? typeParameters;

    /// <summary>Namespace, outer types and name, without numbers of type parameters.</summary>
    public string FullName => Parent is { } parent ? $"{parent.FullName}.{Name}" : Namespace.Length > 0 ? $"{Namespace}.{Name}" : Name;

    public IEnumerable<ApiTypeNode> WithNested() => Nested.SelectMany(n => n.WithNested()).Prepend(this);

    /// <summary>All type parameters in scope, outer types first.</summary>
    public string[] TypeParameters => typeParameters ??= [.. Parent?.TypeParameters ?? [], .. OwnTypeParameters()];
    public string[] OwnParameters => TypeParameters[^Arity..];

    private string[] OwnTypeParameters()
    {
        if (Arity == 0) return [];
        var found = Entry.Constraints.Select(c => c.Name)
            .Concat(Members.Where(m => !m.Id.Contains("``")).SelectMany(m => TypeSyntax.FreeNames(m.ReturnType)))
            .Concat(Entry.Rest.Contains(" : ") ? TypeSyntax.FreeNames(BaseList) : [])
            .Distinct().Take(Arity).ToList();
        for (var i = found.Count; i < Arity; i++) found.Add($"TUnnamed{i}");
        return [.. found];
    }

    public string BaseList
    {
        get
        {
            var text = Entry.Rest;
            var colon = text.IndexOf(" : ", StringComparison.Ordinal);
            if (colon < 0) return "";
            text = text[(colon + 3)..];
            foreach (var stop in new[] { " where ", " !", " @" })
                if (text.IndexOf(stop, StringComparison.Ordinal) is var at and >= 0) text = text[..at];
            return text.Trim();
        }
    }

    /// <summary>Builds the tree of types from list entries; members of unlisted types are dropped.</summary>
    public static List<ApiTypeNode> Build(IEnumerable<ApiEntry> entries)
    {
        var all = entries.ToList();
        var ids = all.Where(e => e.Kind == 'T').Select(e => e.Id).ToHashSet();
        var nodes = new Dictionary<string, ApiTypeNode>();
        var roots = new List<ApiTypeNode>();
        foreach (var entry in all.Where(e => e.Kind == 'T').OrderBy(e => e.Id.Length))
        {
            var dot = entry.Id.LastIndexOf('.');
            var scope = dot < 0 ? "" : entry.Id[..dot];
            var (name, arity) = SplitArity(entry.Id[(dot + 1)..]);
            var nested = ids.Contains(scope);
            var node = new ApiTypeNode(entry, nested ? "" : scope, name, arity);
            if (nested && nodes.TryGetValue(scope, out var parent)) { node.Parent = parent; parent.Nested.Add(node); }
            else roots.Add(node);
            nodes[entry.Id] = node;
        }
        foreach (var entry in all.Where(e => e.Kind != 'T'))
        {
            var paren = entry.Id.IndexOf('(');
            var head = paren < 0 ? entry.Id : entry.Id[..paren];
            var dot = head.LastIndexOf('.');
            if (dot > 0 && nodes.TryGetValue(head[..dot], out var owner)) owner.Members.Add(entry);
        }
        return roots;
    }

    private static (string, int) SplitArity(string name) =>
        name.IndexOf('`') is var tick and >= 0 ? (name[..tick], int.Parse(name[(tick + 1)..])) : (name, 0);
}
