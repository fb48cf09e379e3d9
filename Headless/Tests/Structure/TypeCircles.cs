namespace Headless.Tests.Structure;

/// <summary>Circles of references: sets of types of which each leads to every other (strongly connected components, Tarjan 1972).</summary>
internal sealed class TypeCircles
{
    private readonly IReadOnlyDictionary<string, HashSet<string>> _uses;
    private readonly Dictionary<string, (int Index, int Low)> _visited = [];
    private readonly Stack<string> _path = new();
    private readonly List<IReadOnlyList<string>> _found = [];

    private TypeCircles(IReadOnlyDictionary<string, HashSet<string>> uses)
    {
        _uses = uses;
        foreach (string type in uses.Keys.Order())
        {
            if (!_visited.ContainsKey(type))
            {
                Visit(type);
            }
        }
    }

    /// <summary>All circles of two or more types, the largest first, each sorted by name.</summary>
    public static IReadOnlyList<IReadOnlyList<string>> Find(IReadOnlyDictionary<string, HashSet<string>> uses) =>
        [.. new TypeCircles(uses)._found.OrderByDescending(c => c.Count).ThenBy(c => c[0])];

    private int Visit(string type)
    {
        int index = _visited.Count, low = index;
        _visited[type] = (index, low);
        _path.Push(type);
        foreach (string used in _uses[type])
        {
            if (!_visited.TryGetValue(used, out (int Index, int Low) other))
            {
                low = Math.Min(low, Visit(used));
            }
            else if (_path.Contains(used))
            {
                low = Math.Min(low, other.Index);
            }
        }

        _visited[type] = (index, low);
        if (low == index)
        {
            Take(type);
        }

        return low;
    }

    private void Take(string root)
    {
        List<string> circle = [];
        string type;
        do
        {
            circle.Add(type = _path.Pop());
        }
        while (type != root);
        if (circle.Count > 1)
        {
            circle.Sort(string.CompareOrdinal);
            _found.Add(circle);
        }
    }
}
