namespace Headless.Shaders.SpirV;

/// <summary>Where the values of constant buffers go: through sums, variables, calls and results.</summary>
internal sealed class ConstantFlow
{
    private readonly SpirVIndex index;
    private readonly HashSet<uint> reached = [];
    private readonly Dictionary<uint, SpirVInstruction> values = [];
    private readonly Dictionary<uint, List<uint>> parameters = [];
    private uint function;

    public ConstantFlow(SpirVIndex index)
    {
        this.index = index;
        HashSet<uint> types = [];
        foreach (SpirVInstruction i in index.Module.Instructions)
        {
            Register(i, types);
        }
        for (int before = -1; before < reached.Count;)
        {
            before = reached.Count;
            index.Module.Instructions.ForEach(Follow);
        }
    }

    /// <summary>The type of a value that a function computes.</summary>
    public uint TypeOf(uint value) => values[value][0];

    /// <summary>Whether constants may have a say in where a thread goes on, or in a single number that is put out or put at an index.</summary>
    public bool Decides(SpirVInstruction i) => i.Op switch
    {
        SpirVOp.BranchConditional or SpirVOp.Switch => IsComputed(i[0]),
        SpirVOp.Store => IsComputed(i[1]) && index.Definition(TypeOf(i[1])).Op is SpirVOp.TypeInt or SpirVOp.TypeFloat && StaysInMemory(i[0]),
        _ => false,
    };

    private bool IsComputed(uint value) => reached.Contains(value) && values.ContainsKey(value);

    private void Register(SpirVInstruction i, HashSet<uint> types)
    {
        switch (i.Op)
        {
            case >= SpirVOp.TypeVoid and <= SpirVOp.TypeFunction:
                types.Add(i[0]);
                break;
            case SpirVOp.Function:
                function = i[1];
                parameters[function] = [];
                break;
            case SpirVOp.Variable when (SpirVStorage)i[2] == SpirVStorage.Uniform && !index.Has(index.Pointee(i), SpirVDecoration.BufferBlock):
                reached.Add(i[1]);
                goto default;
            case SpirVOp.FunctionParameter:
                parameters[function].Add(i[1]);
                goto default;
            default:
                // What has a result begins with its type; what stands before the functions is no computed value, but for variables.
                if ((function != 0 || i.Op == SpirVOp.Variable) && i.Operands.Length > 1 && types.Contains(i[0]))
                {
                    values[i[1]] = i;
                }
                break;
        }
    }

    private void Follow(SpirVInstruction i)
    {
        switch (i.Op)
        {
            case SpirVOp.Function:
                function = i[1];
                break;
            case SpirVOp.ReturnValue when reached.Contains(i[0]):
                reached.Add(function);
                break;
            case SpirVOp.Store when reached.Contains(i[1]):
                reached.Add(Root(i[0]));
                break;
            case SpirVOp.FunctionCall:
                FollowCall(i);
                break;
            default:
                if (i.Operands.Length > 1 && values.GetValueOrDefault(i[1]) == i && i.Operands.Skip(2).Any(reached.Contains))
                {
                    reached.Add(i[1]);
                }
                break;
        }
    }

    private void FollowCall(SpirVInstruction call)
    {
        List<uint> taken = parameters[call[2]];
        for (int n = 0; n < taken.Count; n++)
        {
            uint argument = call[n + 3];
            if (reached.Contains(argument))
            {
                reached.Add(taken[n]);
            }
            else if (reached.Contains(taken[n]) && values.TryGetValue(argument, out SpirVInstruction? origin) && index.Definition(origin[0]).Op == SpirVOp.TypePointer)
            {
                reached.Add(Root(argument));
            }
        }
        if (reached.Contains(call[2]))
        {
            reached.Add(call[1]);
        }
    }

    // The variable or parameter of which a pointer names a part.
    private uint Root(uint pointer)
    {
        while (values[pointer].Op is SpirVOp.AccessChain or SpirVOp.InBoundsAccessChain or SpirVOp.CopyObject)
        {
            pointer = values[pointer][2];
        }
        return pointer;
    }

    private bool StaysInMemory(uint pointer)
    {
        SpirVInstruction root = values[Root(pointer)];
        SpirVStorage storage = (SpirVStorage)index.Definition(root[0])[1];
        return storage == SpirVStorage.Output
            || storage is SpirVStorage.Function or SpirVStorage.Private && values[pointer].Operands.Skip(3).Any(values.ContainsKey);
    }
}
