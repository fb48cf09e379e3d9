using System.Globalization;

namespace Headless.Checks.Documents.Facts;

/// <summary>
/// What the methods are: <c>methods:can</c> is the table of what each can do, <c>methods:or:ForceZones</c> says which have it, <c>bytes:…</c> and <c>requires:…</c> what they need.
/// </summary>
internal sealed class MethodFacts
{
    // A box of liquid in which no part is at a limit.
    private const float Spacing = 0.02f;
    private const int Particles = 1 << 16;

    private readonly PackageProgram program;
    private readonly IReadOnlyList<Capability> capabilities;
    private readonly Dictionary<string, object> methods;

    public MethodFacts(ProjectPackages packages, PackageProgram program)
    {
        this.program = program;
        capabilities = Capability.Read(packages.Project);
        methods = program.Each("FluidMethod", Enum.Parse(program.Type("FluidMethodKind"), "Thesis")).ToDictionary(m => PackageProgram.Get(m, "Kind")!.ToString()!);
        string[] features = [.. Enum.GetNames(program.Type("FluidMethodFeatures")).Where(n => n != "None")], listed = [.. capabilities.Where(c => !c.IsOfAll).Select(c => c.Feature)];
        if (features.Except(listed).Concat(listed.Except(features)).FirstOrDefault() is { } odd)
            throw new UnknownFactException($"Facts/Data/capabilities.csv and FluidMethodFeatures do not have the same names: {odd}");
    }

    /// <summary>The methods in the order in which documents name them.</summary>
    public IReadOnlyList<string> Names => [.. methods.Keys.OrderBy(n => Array.IndexOf(["Standard", "Robust", "Thesis"], n) is var place and >= 0 ? place : int.MaxValue)];

    public IReadOnlyList<string> With(string feature) => [.. Names.Where(n => feature.Length == 0 || ((Enum)PackageProgram.Get(methods[n], "Features")!).HasFlag((Enum)Parse(feature)))];

    public string Find(string[] words) => words switch
    {
        ["can"] => Table(),
        ["and", var feature] => FactText.List(With(feature)),
        ["or", var feature] => FactText.List(With(feature), "or"),
        _ => throw new UnknownFactException("it is none of methods:can, methods:and:FEATURE and methods:or:FEATURE"),
    };

    /// <summary><c>bytes:Standard:particle</c>, <c>list</c>, <c>walls</c> and <c>cell</c>: GPU memory of a particle, of what it needs more for a list and for colliders, of a cell.</summary>
    public string Bytes(string[] words) => words is [var method, var part] && methods.ContainsKey(method) ? FactText.Number(Bytes(method, part)) : throw new UnknownFactException("a method and a part");

    /// <summary><c>requires:Standard</c>, <c>requires:Whitewater</c>: threads a group, buffers, those written and shared memory, as cells of a table.</summary>
    public string Requires(string[] words)
    {
        var group = words is [var part] ? methods.TryGetValue(part, out var method) ? PackageProgram.Get(method, "Shaders")! : program.Constant("ShaderGroup", part) : throw new UnknownFactException("a part");
        return string.Join(" | ", new[] { "GroupThreads", "Buffers", "WritableBuffers", "GroupMemory" }.Select(n => FactText.Number(Most(group, n))));

        static double Most(object group, string number) =>
            Math.Max(Convert.ToDouble(PackageProgram.Get(group, number), CultureInfo.InvariantCulture), PackageProgram.Get(group, "Shared") is { } shared ? Most(shared, number) : 0);
    }

    private double Bytes(string method, string part)
    {
        program.OpenDevice();
        return part switch
        {
            "particle" => Each(p => State(p)),
            "walls" => Each(p => State(p, withWalls: true)) - Each(p => State(p)),
            "list" => Each(p => program.Make("NeighbourList", p, program.CallOf("NeighbourList", "LengthFor", Settings(method, 1f)), true)),
            // Small enough that all cells are stored.
            "cell" => Math.Round((Of(State(Particles, size: 4f)) - Of(State(Particles, size: 3f))) / (Cells(4f) - Cells(3f))),
            _ => throw new UnknownFactException($"'{part}' is none of particle, list, walls and cell"),
        };

        double Each(Func<int, object> make) => Math.Round((Of(make(2 * Particles)) - Of(make(Particles))) / Particles);

        object State(int particles, bool withWalls = false, float size = 1f)
        {
            var state = program.Make(method + "State", Settings(method, size), particles, true);
            if (withWalls) PackageProgram.Call(state, "RequireWalls");
            return state;
        }
    }

    private static double Of(object buffers)
    {
        using var owned = (IDisposable)buffers;
        return Convert.ToDouble(PackageProgram.Get(buffers, "Bytes"), CultureInfo.InvariantCulture);
    }

    private static double Cells(float size) => Math.Pow(Math.Ceiling(size / (2.25 * Spacing)) + 2, 3);

    private object Settings(string method, float size)
    {
        var input = program.Static("FluidRuleInput", "Water");
        var domain = PackageProgram.Get(input, "DomainSize")!;
        foreach (var axis in new[] { "x", "y", "z" }) PackageProgram.Set(domain, axis, size);
        foreach (var (field, value) in new (string, object)[] { ("Method", Parse("FluidMethodKind", method)), ("Spacing", Spacing), ("LiquidHeight", 1f), ("LiquidDepth", 0.5f), ("DomainSize", domain) })
            PackageProgram.Set(input, field, value);
        return PackageProgram.Call(methods[method], "Derive", input)!;
    }

    private string Table()
    {
        var rows = new List<string> { $"| | {string.Join(" | ", Names)} |", $"|---|{string.Concat(Names.Select(_ => "---|"))}" };
        foreach (var same in capabilities.Where(c => c.Label.Length > 0 && !c.IsOfAll).GroupBy(c => string.Join(' ', With(c.Feature))))
        {
            var label = string.Join("; ", same.Select(c => c.Label));
            var with = With(same.First().Feature);
            rows.Add($"| {char.ToUpperInvariant(label[0])}{label[1..]} | {string.Join(" | ", Names.Select(n => with.Contains(n) ? "yes" : "no"))} |");
        }
        return string.Join('\n', rows) + "\n";
    }

    private object Parse(string feature) => Parse("FluidMethodFeatures", feature);

    private object Parse(string type, string name) => Enum.TryParse(program.Type(type), name, out var value) ? value! : throw new UnknownFactException($"{type} has no {name}");
}
