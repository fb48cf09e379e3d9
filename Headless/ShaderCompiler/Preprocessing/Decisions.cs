namespace Headless.Shaders.Preprocessing;

/// <summary>Conditions over what differs from variant to variant, as reduced ordered binary decision diagrams.</summary>
/// <remarks>
/// A condition is a number; equal conditions have equal numbers, so one that always or never holds is seen at once.
/// Bryant, "Graph-Based Algorithms for Boolean Function Manipulation", IEEE Transactions on Computers C-35 (1986).
/// </remarks>
internal sealed class Decisions
{
    public const int Never = 0;
    public const int Always = 1;

    private const int MostVariables = 2000;
    private const int MostSteps = 20_000_000;

    private readonly record struct Node(int Variable, int High, int Low);

    private readonly List<Node> _nodes = [new(int.MaxValue, 0, 0), new(int.MaxValue, 1, 1)];
    private readonly Dictionary<Node, int> _numbers = [];
    private readonly Dictionary<(int, int, int), int> _chosen = [];
    private readonly Dictionary<string, int> _variables = [];
    private int _steps;

    /// <summary>Whether there was more to do than any shader needs; answers are of no use then.</summary>
    public bool IsExhausted => _steps > MostSteps || _variables.Count > MostVariables;

    /// <summary>The condition of a name.</summary>
    public int Variable(string name)
    {
        if (_variables.TryGetValue(name, out int found)) return found;
        int made = Number(new Node(_variables.Count, Always, Never));
        _variables.Add(name, made);
        return made;
    }

    public int And(int a, int b) => Choose(a, b, Never);

    public int Or(int a, int b) => Choose(a, Always, b);

    public int Not(int a) => Choose(a, Never, Always);

    private int Choose(int condition, int then, int otherwise)
    {
        if (condition == Always || then == otherwise) return then;
        if (condition == Never) return otherwise;
        if (then == Always && otherwise == Never) return condition;
        (int, int, int) key = (condition, then, otherwise);
        if (++_steps > MostSteps || IsExhausted) return Never;
        if (_chosen.TryGetValue(key, out int known)) return known;
        int variable = Math.Min(_nodes[condition].Variable, Math.Min(_nodes[then].Variable, _nodes[otherwise].Variable));
        int high = Choose(High(condition, variable), High(then, variable), High(otherwise, variable));
        int low = Choose(Low(condition, variable), Low(then, variable), Low(otherwise, variable));
        return _chosen[key] = high == low ? high : Number(new Node(variable, high, low));
    }

    private int High(int condition, int variable) => _nodes[condition].Variable == variable ? _nodes[condition].High : condition;

    private int Low(int condition, int variable) => _nodes[condition].Variable == variable ? _nodes[condition].Low : condition;

    private int Number(Node node)
    {
        if (_numbers.TryGetValue(node, out int number)) return number;
        _nodes.Add(node);
        return _numbers[node] = _nodes.Count - 1;
    }
}
