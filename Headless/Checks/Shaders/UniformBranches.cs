using Headless.Shaders.SpirV;

namespace Headless.Checks.Shaders;

/// <summary>Finds branches whose condition is computed from uniforms and constants alone, in optimized SPIR-V (functions inlined, values in SSA form).</summary>
/// <remarks>A loop's counter counts as constant where the loop ends: it goes up from a constant by constants.</remarks>
internal sealed class UniformBranches
{
    private const int VectorShuffle = 79, CompositeExtract = 81, CompositeInsert = 82;

    private readonly SpirVIndex index;
    private readonly Dictionary<uint, SpirVInstruction> made = [];
    private readonly Dictionary<uint, IReadOnlySet<string>?> known = [];
    private bool countersCount;

    private UniformBranches(SpirVModule module)
    {
        index = new SpirVIndex(module);
        foreach (var instruction in module.Instructions.Where(HasResult)) made[instruction[1]] = instruction;
    }

    public static IReadOnlyList<UniformBranch> Find(byte[] spirV)
    {
        var module = new SpirVModule(spirV);
        return [.. new UniformBranches(module).Find(module)];
    }

    private IEnumerable<UniformBranch> Find(SpirVModule module)
    {
        var ends = module.Instructions.Where(i => i.Op == SpirVOp.LoopMerge).Select(i => i[0]).ToHashSet();
        var line = 0;
        foreach (var instruction in module.Instructions)
        {
            if (instruction.Op == SpirVOp.Line) line = (int)instruction[1];
            if (instruction.Op is not (SpirVOp.BranchConditional or SpirVOp.Switch)) continue;
            var endsLoop = instruction.Op == SpirVOp.BranchConditional && (ends.Contains(instruction[1]) || ends.Contains(instruction[2]));
            known.Clear();
            countersCount = endsLoop;
            if (Uniforms(instruction[0]) is { Count: > 0 } names) yield return new UniformBranch(string.Join(' ', names.Order(StringComparer.Ordinal)), endsLoop, line);
        }
    }

    // Names of the uniforms that a value is computed from: none for a constant, null where it depends on anything else.
    private IReadOnlySet<string>? Uniforms(uint id)
    {
        if (!made.TryGetValue(id, out var instruction)) return new HashSet<string>();
        if (known.TryGetValue(id, out var names)) return names;
        // A phi that comes to itself through its loop adds nothing.
        if (instruction.Op == SpirVOp.Phi) known[id] = new HashSet<string>();
        return known[id] = Of(instruction);
    }

    private IReadOnlySet<string>? Of(SpirVInstruction i) => i.Op switch
    {
        SpirVOp.Load => OfLoad(i[2]),
        SpirVOp.Phi => countersCount ? All(i.Operands.Skip(2).Where((_, place) => place % 2 == 0)) : null,
        SpirVOp.ExtInst => All(i.Operands.Skip(4)),
        (SpirVOp)VectorShuffle or (SpirVOp)CompositeInsert => All(i.Operands.Skip(2).Take(2)),
        (SpirVOp)CompositeExtract => Uniforms(i[2]),
        _ when IsArithmetic(i.Op) => All(i.Operands.Skip(2)),
        _ => null,
    };

    private IReadOnlySet<string>? OfLoad(uint pointer)
    {
        var members = new List<uint>();
        while (made.TryGetValue(pointer, out var chain) && chain.Op is SpirVOp.AccessChain or SpirVOp.InBoundsAccessChain)
        {
            members.InsertRange(0, chain.Operands.Skip(3));
            pointer = chain[2];
        }
        if (index.Variables.Find(v => v[1] == pointer) is not { } variable || (SpirVStorage)variable[2] != SpirVStorage.Uniform) return null;
        var block = index.Pointee(variable);
        if (!index.Has(block, SpirVDecoration.Block) || members.Exists(made.ContainsKey)) return null;
        return new HashSet<string> { members.Count > 0 ? index.MemberName(block, (int)index.ConstantValue(members[0])) : index.Name(pointer) };
    }

    private IReadOnlySet<string>? All(IEnumerable<uint> ids)
    {
        var all = new HashSet<string>();
        foreach (var id in ids)
        {
            if (Uniforms(id) is not { } names) return null;
            all.UnionWith(names);
        }
        return all;
    }

    private static bool IsArithmetic(SpirVOp op) => (int)op is >= 77 and <= 84 or >= 109 and <= 124 or >= 126 and <= 152 or >= 154 and <= 191 or >= 194 and <= 205;

    // What can stand in a condition; all others count as depending on more than uniforms.
    private static bool HasResult(SpirVInstruction i) =>
        i.Op is SpirVOp.Load or SpirVOp.Phi or SpirVOp.ExtInst or SpirVOp.AccessChain or SpirVOp.InBoundsAccessChain || IsArithmetic(i.Op)
        || i.Op is SpirVOp.ArrayLength or SpirVOp.FunctionCall or SpirVOp.FunctionParameter
        || (int)i.Op is 60 or >= 86 and <= 106 or >= 207 and <= 215 or 227 or >= 229 and <= 242 or >= 333 and <= 366;
}
