namespace Headless.Checks.Api;

/// <summary>
/// What source that compiles against one line can notice of another. Source that uses no entry that differs, names nothing that is gone and
/// meets no new name compiles in the other line as it does in this.
/// </summary>
internal sealed class ApiDifference
{
    private readonly HashSet<string> there;
    private readonly HashSet<string> changedTypes = [];
    private readonly HashSet<string> overloaded = [];
    private readonly HashSet<string> extended = [];
    private readonly HashSet<string> gone;
    private readonly HashSet<string> inherited = [];
    private readonly List<ApiTypeNode> newTypes;
    private readonly List<string[]> newConversions = [];

    /// <param name="here">Reached types of the line that the source is compiled against.</param>
    /// <param name="other">Those of the other line.</param>
    /// <param name="bases">Names of the types that the source derives from.</param>
    public ApiDifference(IReadOnlyList<ApiTypeNode> here, IReadOnlyList<ApiTypeNode> other, IReadOnlySet<string> bases)
    {
        var known = here.SelectMany(Signatures).ToHashSet();
        there = other.SelectMany(Signatures).ToHashSet();
        gone = [.. here.SelectMany(Names).Except(other.SelectMany(Names))];
        var ids = here.Select(n => n.Entry.Id).ToHashSet();
        newTypes = other.Where(n => n.Parent is null && !ids.Contains(n.Entry.Id)).ToList();
        var derived = Ancestors(other, bases);
        changedTypes.UnionWith(here.Where(n => !there.Contains(n.Entry.Signature)).Select(n => n.Entry.Id));
        foreach (var node in other)
        {
            if (node.Parent is { } parent && derived.Contains(parent) && !ids.Contains(node.Entry.Id)) inherited.Add(node.Name);
            foreach (var member in node.Reached!.Where(m => !known.Contains(m.Signature)))
            {
                if (node.Entry.Has("interface") || member.Has("abstract")) changedTypes.Add(node.Entry.Id);
                overloaded.Add($"{node.Entry.Id}.{member.Name}");
                if (member.IsExtension) extended.Add(member.Name);
                if (derived.Contains(node)) inherited.Add(member.Name);
                if (member.Name is "op_Implicit" or "op_Explicit")
                    newConversions.Add([.. ApiReach.Mentions(member.Signature).Select(t => t[(t.LastIndexOf('.') + 1)..]).Append(node.Name).Where(t => !t.StartsWith("op_")).Distinct()]);
            }
        }
        changedTypes.UnionWith(here.Where(n => newTypes.Exists(t => t.Name == n.Name)).Select(n => n.Entry.Id));
    }

    /// <summary>Whether a use of an entry of this line may mean something else in the other, or nothing.</summary>
    public bool Concerns(ApiTypeNode type, ApiEntry entry) => changedTypes.Contains(type.Entry.Id) || !there.Contains(entry.Signature)
        || overloaded.Contains($"{type.Entry.Id}.{entry.Name}") || (entry.IsExtension && extended.Contains(entry.Name));

    /// <summary>Whether a file meets a name or a conversion that is new there, or has a name that is gone.</summary>
    public bool Concerns(PackageSources.Source file) => gone.Overlaps(file.Words) || inherited.Overlaps(file.Words)
        || newConversions.Exists(file.Words.IsSupersetOf)
        || newTypes.Exists(t => file.Words.Contains(t.Name) && file.Text.Contains($"using {t.Namespace}", StringComparison.Ordinal));

    private static IEnumerable<string> Signatures(ApiTypeNode node) => node.Reached!.Select(m => m.Signature).Prepend(node.Entry.Signature);

    private static IEnumerable<string> Names(ApiTypeNode node) => node.Reached!.Select(m => m.Name).Prepend(node.Name);

    private static HashSet<ApiTypeNode> Ancestors(IReadOnlyList<ApiTypeNode> types, IReadOnlySet<string> names)
    {
        var byName = types.ToLookup(t => t.FullName);
        HashSet<ApiTypeNode> found = [];
        var open = new Stack<ApiTypeNode>(types.Where(t => names.Contains(t.Name)));
        while (open.TryPop(out var node))
            if (found.Add(node))
                foreach (var name in ApiReach.Mentions(node.BaseList)) foreach (var parent in byName[name]) open.Push(parent);
        return found;
    }
}
