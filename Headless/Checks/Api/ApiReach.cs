namespace Headless.Checks.Api;

/// <summary>
/// The part of an API that source can see. Source names what it uses, so a member whose name is no word of it is left out, except for what is
/// used without a name: constructors, operators, indexers, what a class must implement, and what foreach, using and await call. With a member
/// come the types of its signature. A tenth of the API is left, and compiles to the same messages.
/// </summary>
internal sealed class ApiReach
{
    private static readonly HashSet<string> unnamed =
        ["#ctor", "Invoke", "GetEnumerator", "MoveNext", "Current", "Dispose", "Add", "Deconstruct", "GetAwaiter", "GetResult", "IsCompleted", "OnCompleted", "GetPinnableReference", "Item", "Length", "Count", "Slice"];

    private readonly IReadOnlySet<string> words;
    private readonly ILookup<string, ApiTypeNode> types;
    private readonly Stack<ApiTypeNode> open = new();
    private readonly List<ApiTypeNode> reached;

    private ApiReach(IEnumerable<ApiTypeNode> roots, IReadOnlySet<string> words)
    {
        this.words = words;
        var all = roots.SelectMany(r => r.WithNested()).ToList();
        types = all.ToLookup(n => n.FullName);
        foreach (var node in all.Where(n => n.Parent is null && IsNamed(n) || n.Members.Exists(IsNamedExtension))) Reach(node);
        while (open.TryPop(out var node)) Follow(node);
        reached = all.FindAll(n => n.Reached is not null);
    }

    /// <summary>Marks what is reached.</summary>
    /// <param name="roots">Types of every assembly of the API.</param>
    /// <param name="words">All words of the source.</param>
    /// <returns>The types, nested ones too.</returns>
    public static IReadOnlyList<ApiTypeNode> Mark(IEnumerable<ApiTypeNode> roots, IReadOnlySet<string> words) => new ApiReach(roots, words).reached;

    private bool IsNamed(ApiTypeNode node) => words.Contains(node.Name)
        || (node.Name.EndsWith("Attribute", StringComparison.Ordinal) && words.Contains(node.Name[..^"Attribute".Length]));

    private bool IsNamedExtension(ApiEntry member) => member.IsExtension && words.Contains(member.Name);

    private void Reach(ApiTypeNode node)
    {
        if (node.Reached is not null) return;
        node.Reached = [];
        open.Push(node);
        if (node.Parent is { } parent) Reach(parent);
    }

    private void Follow(ApiTypeNode node)
    {
        var isInterface = node.Entry.Has("interface");
        node.Reached!.AddRange(node.Members.Where(m => isInterface || words.Contains(m.Name) || unnamed.Contains(m.Name)
            || m.Name.StartsWith("op_", StringComparison.Ordinal) || m.Has("abstract")));
        foreach (var nested in node.Nested.Where(IsNamed)) Reach(nested);
        foreach (var entry in node.Reached.Prepend(node.Entry))
            foreach (var name in Mentions(entry))
                foreach (var mentioned in types[name]) Reach(mentioned);
    }

    private static IEnumerable<string> Mentions(ApiEntry entry)
    {
        var parameters = entry.Id.IndexOf('(');
        return Mentions(parameters < 0 ? entry.Rest : entry.Id[parameters..] + " " + entry.Rest);
    }

    /// <summary>Types that a signature names, without their arguments.</summary>
    /// <example>A.List{B.Item}.Enumerator names A.List, B.Item and A.List.Enumerator.</example>
    public static IEnumerable<string> Mentions(string signature)
    {
        var generic = new Stack<string>();
        var name = "";
        for (var i = 0; i < signature.Length; i++)
        {
            var start = i;
            while (i < signature.Length && (char.IsLetterOrDigit(signature[i]) || signature[i] is '_' or '.')) i++;
            if (i > start)
            {
                name = (signature[start] == '.' ? name : "") + signature[start..i];
                if (name.Contains('.')) yield return name;
            }
            if (i == signature.Length) break;
            if (signature[i] is '<' or '{') generic.Push(name);
            else if (signature[i] is '>' or '}' && generic.TryPop(out var outer)) name = outer;
        }
    }
}
