namespace Headless.Shaders.SpirV;

/// <summary>Adds types, constants, variables and functions to a module; a type or constant that exists is used again.</summary>
internal sealed class ModuleEditor(SpirVIndex index)
{
    public SpirVModule Module => index.Module;

    public uint Void => Type(SpirVOp.TypeVoid);

    public uint Bool => Type(SpirVOp.TypeBool);

    public uint UInt => Type(SpirVOp.TypeInt, 32, 0);

    public uint Type(SpirVOp op, params uint[] operands)
    {
        SpirVInstruction? found = Module.Instructions.Find(i => i.Op == op && i.Operands.AsSpan(1).SequenceEqual(operands));
        return found is null ? NewType(op, operands) : found[0];
    }

    /// <summary>A type of its own even where an equal one exists, as a decorated struct needs.</summary>
    public uint NewType(SpirVOp op, params uint[] operands)
    {
        uint id = Module.NewId();
        AddGlobal(new SpirVInstruction(op, [id, .. operands]));
        return id;
    }

    public uint Pointer(SpirVStorage storage, uint type) => Type(SpirVOp.TypePointer, (uint)storage, type);

    public uint Constant(uint value) => Constant(SpirVOp.Constant, UInt, value);

    public uint Constant(SpirVOp op, uint type, params uint[] words)
    {
        SpirVInstruction? found = Module.Instructions.Find(
            i => i.Op == op && i[0] == type && i.Operands.AsSpan(2).SequenceEqual(words));
        if (found is not null)
        {
            return found[1];
        }
        uint id = Module.NewId();
        AddGlobal(new SpirVInstruction(op, [type, id, .. words]));
        return id;
    }

    public uint Variable(SpirVStorage storage, uint type, params uint[] initializer)
    {
        uint id = Module.NewId();
        AddGlobal(new SpirVInstruction(SpirVOp.Variable, [Pointer(storage, type), id, (uint)storage, .. initializer]));
        return id;
    }

    public void Decorate(params uint[] operands) =>
        Module.Instructions.Insert(index.FirstType(), new SpirVInstruction(SpirVOp.Decorate, operands));

    /// <summary>The input variable of a built-in; one is added, and named at the entry point, where there is none.</summary>
    public uint BuiltInInput(uint builtIn) => BuiltInInput(builtIn, UInt, out _);

    /// <param name="type">Type of the one that is added.</param>
    /// <param name="found">Type of the one that there is.</param>
    public uint BuiltInInput(uint builtIn, uint type, out uint found)
    {
        foreach (SpirVInstruction variable in index.Variables)
        {
            if ((SpirVStorage)variable[2] == SpirVStorage.Input && index.Find(variable[1], SpirVDecoration.BuiltIn)?[2] == builtIn)
            {
                found = index.Pointee(variable);
                return variable[1];
            }
        }
        found = type;
        uint id = Variable(SpirVStorage.Input, type);
        Decorate(id, (uint)SpirVDecoration.BuiltIn, builtIn);
        SpirVInstruction entry = Entry;
        entry.Operands = [.. entry.Operands, id];
        return id;
    }

    /// <summary>Appends a function without parameters or result.</summary>
    public uint AddFunction(IEnumerable<SpirVInstruction> body)
    {
        uint function = Module.NewId();
        uint type = Type(SpirVOp.TypeFunction, Void);
        Module.Instructions.Add(new SpirVInstruction(SpirVOp.Function, Void, function, 0, type));
        Module.Instructions.AddRange(body);
        Module.Instructions.Add(new SpirVInstruction(SpirVOp.FunctionEnd));
        return function;
    }

    public SpirVInstruction Call(uint function) => new(SpirVOp.FunctionCall, Void, Module.NewId(), function);

    /// <summary>Position of the entry point's function.</summary>
    public int EntryFunction() => Module.Instructions.FindIndex(i => i.Op == SpirVOp.Function && i[1] == Entry[1]);

    /// <summary>Position of the first instruction of the entry point's function that is neither a label nor a variable.</summary>
    public int EntryStart()
    {
        int at = EntryFunction() + 1;
        while (Module.Instructions[at].Op is SpirVOp.Label or SpirVOp.Variable)
        {
            at++;
        }
        return at;
    }

    private SpirVInstruction Entry => Module.Instructions.Find(i => i.Op == SpirVOp.EntryPoint)!;

    private void AddGlobal(SpirVInstruction instruction) =>
        Module.Instructions.Insert(Module.Instructions.FindIndex(i => i.Op == SpirVOp.Function), instruction);
}
