namespace Headless.Shaders.SpirV;

/// <summary>Look-up tables over a module: definitions, names and decorations by id.</summary>
internal sealed class SpirVIndex
{
    private readonly Dictionary<uint, SpirVInstruction> _definitions = [];
    private readonly Dictionary<uint, string> _names = [];
    private readonly Dictionary<(uint, uint), string> _memberNames = [];
    private readonly Dictionary<(uint, SpirVDecoration), SpirVInstruction> _decorations = [];
    private readonly Dictionary<(uint, uint, SpirVDecoration), SpirVInstruction> _memberDecorations = [];

    public SpirVModule Module { get; }
    public List<SpirVInstruction> Variables { get; } = [];

    public SpirVIndex(SpirVModule module)
    {
        Module = module;
        foreach (SpirVInstruction instruction in module.Instructions)
        {
            Add(instruction);
        }
    }

    private void Add(SpirVInstruction i)
    {
        switch (i.Op)
        {
            case SpirVOp.Name:
                _names[i[0]] = i.Text(1);
                break;
            case SpirVOp.MemberName:
                _memberNames[(i[0], i[1])] = i.Text(2);
                break;
            case SpirVOp.Decorate:
            case SpirVOp.DecorateString:
                _decorations[(i[0], (SpirVDecoration)i[1])] = i;
                break;
            case SpirVOp.MemberDecorate:
                _memberDecorations[(i[0], i[1], (SpirVDecoration)i[2])] = i;
                break;
            case >= SpirVOp.TypeBool and <= SpirVOp.TypePointer:
                _definitions[i[0]] = i;
                break;
            case SpirVOp.Constant:
                _definitions[i[1]] = i;
                break;
            case SpirVOp.Variable:
                _definitions[i[1]] = i;
                if ((SpirVStorage)i[2] is SpirVStorage.UniformConstant or SpirVStorage.Uniform or SpirVStorage.StorageBuffer
                    or SpirVStorage.Input or SpirVStorage.Output or SpirVStorage.Workgroup)
                {
                    Variables.Add(i);
                }
                break;
        }
    }

    public SpirVInstruction Definition(uint id) => _definitions[id];

    public string Name(uint id) => _names.GetValueOrDefault(id, "");

    public string MemberName(uint type, int member) => _memberNames.GetValueOrDefault((type, (uint)member), "");

    public bool Has(uint id, SpirVDecoration decoration) => _decorations.ContainsKey((id, decoration));

    public SpirVInstruction? Find(uint id, SpirVDecoration decoration) => _decorations.GetValueOrDefault((id, decoration));

    public SpirVInstruction? Find(uint type, int member, SpirVDecoration decoration) =>
        _memberDecorations.GetValueOrDefault((type, (uint)member, decoration));

    /// <summary>Sets a one-word decoration, adding it where it is missing.</summary>
    public void Set(uint id, SpirVDecoration decoration, uint value)
    {
        if (_decorations.TryGetValue((id, decoration), out SpirVInstruction? found))
        {
            found[2] = value;
            return;
        }
        Insert(new SpirVInstruction(SpirVOp.Decorate, id, (uint)decoration, value));
    }

    /// <summary>Puts a one-word decoration in the place of another.</summary>
    public void Replace(uint id, SpirVDecoration old, SpirVDecoration decoration, uint value)
    {
        if (_decorations.Remove((id, old), out SpirVInstruction? found))
        {
            Module.Instructions.Remove(found);
        }
        Set(id, decoration, value);
    }

    public void SetFlag(uint id, SpirVDecoration decoration)
    {
        if (!Has(id, decoration))
        {
            Insert(new SpirVInstruction(SpirVOp.Decorate, id, (uint)decoration));
        }
    }

    public void Set(uint type, int member, SpirVDecoration decoration, uint value)
    {
        if (_memberDecorations.TryGetValue((type, (uint)member, decoration), out SpirVInstruction? found))
        {
            found[3] = value;
            return;
        }
        Insert(new SpirVInstruction(SpirVOp.MemberDecorate, type, (uint)member, (uint)decoration, value));
    }

    private void Insert(SpirVInstruction decoration)
    {
        Module.Instructions.Insert(FirstType(), decoration);
        Add(decoration);
    }

    /// <summary>Index of the first instruction of the types section, which follows the decorations.</summary>
    public int FirstType() => Module.Instructions.FindIndex(i => i.Op is (SpirVOp)19 or >= SpirVOp.TypeBool and <= SpirVOp.TypePointer);

    /// <summary>The type a variable's pointer points at.</summary>
    public uint Pointee(SpirVInstruction variable) => _definitions[variable[0]][2];

    public uint ConstantValue(uint id) => _definitions[id][2];

    public uint ArrayLength(SpirVInstruction array) => ConstantValue(array[2]);
}
