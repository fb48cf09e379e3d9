namespace Headless.Shaders.SpirV;

/// <summary>Makes integers of floats as Direct3D does; SPIR-V leaves it open outside the integer's range.</summary>
/// <remarks>
/// ftoi and ftou go to the nearest integer that exists, and give 0 for what is not a number (Direct3D 11.3 functional specification,
/// "ftoi" and "ftou"): (int)3e9 is 2147483647, (uint)-1.5 is 0.
/// </remarks>
internal sealed class FloatConversions
{
    private readonly SpirVModule _module;
    private readonly SpirVIndex _index;
    private readonly List<SpirVInstruction> _declared = [];
    private readonly Dictionary<(uint Type, uint Bits), uint> _constants = [];
    private readonly Dictionary<uint, uint> _typeOf = [];

    private FloatConversions(SpirVModule module)
    {
        _module = module;
        _index = new SpirVIndex(module);
    }

    public static void Clamp(SpirVModule module) => new FloatConversions(module).Rewrite();

    private void Rewrite()
    {
        foreach (SpirVInstruction i in _module.Instructions.Where(i => i.Op is SpirVOp.Constant or SpirVOp.ConstantComposite))
        {
            _typeOf[i[1]] = i[0];
        }
        int body = _module.Instructions.FindIndex(i => i.Op == SpirVOp.Function);
        List<SpirVInstruction> rewritten = [];
        foreach (SpirVInstruction i in _module.Instructions.Skip(body))
        {
            if (i.Op is SpirVOp.ConvertFToS or SpirVOp.ConvertFToU)
            {
                rewritten.AddRange(Clamped(i));
                continue;
            }
            rewritten.Add(i);
            if (i.Operands.Length > 2)
            {
                // Where an instruction has no result, its second operand is known already, or a label.
                _typeOf.TryAdd(i[1], i[0]);
            }
        }
        _module.Instructions.RemoveRange(body, _module.Instructions.Count - body);
        _module.Instructions.AddRange(_declared);
        _module.Instructions.AddRange(rewritten);
    }

    // Each choice overrules the one before: too large, too small, not a number.
    private IEnumerable<SpirVInstruction> Clamped(SpirVInstruction conversion)
    {
        bool signed = conversion.Op == SpirVOp.ConvertFToS;
        (uint type, uint result, uint x) = (conversion[0], conversion[1], conversion[2]);
        uint floats = _typeOf[x];
        (float low, float high, uint least, uint most) = signed
            ? (-2147483648f, 2147483648f, 0x80000000u, 0x7fffffffu)
            : (0f, 4294967296f, 0u, uint.MaxValue);
        uint bools = Bools(type);
        uint converted = _module.NewId(), large = _module.NewId(), first = _module.NewId();
        uint small = _module.NewId(), second = _module.NewId(), nan = _module.NewId();
        return
        [
            new SpirVInstruction(conversion.Op, type, converted, x),
            new SpirVInstruction(SpirVOp.FOrdGreaterThanEqual, bools, large, x, Constant(floats, BitConverter.SingleToUInt32Bits(high))),
            new SpirVInstruction(SpirVOp.Select, type, first, large, Constant(type, most), converted),
            new SpirVInstruction(SpirVOp.FOrdLessThan, bools, small, x, Constant(floats, BitConverter.SingleToUInt32Bits(low))),
            new SpirVInstruction(SpirVOp.Select, type, second, small, Constant(type, least), first),
            new SpirVInstruction(SpirVOp.IsNan, bools, nan, x),
            new SpirVInstruction(SpirVOp.Select, type, result, nan, Constant(type, 0), second),
        ];
    }

    private (uint Scalar, int Size) Shape(uint type)
    {
        SpirVInstruction definition = _index.Definition(type);
        return definition.Op == SpirVOp.TypeVector ? (definition[1], (int)definition[2]) : (type, 1);
    }

    private uint Bools(uint type)
    {
        int size = Shape(type).Size;
        uint scalar = Type(i => i.Op == SpirVOp.TypeBool, id => new SpirVInstruction(SpirVOp.TypeBool, id));
        return size == 1 ? scalar : Type(
            i => i.Op == SpirVOp.TypeVector && i[1] == scalar && i[2] == size,
            id => new SpirVInstruction(SpirVOp.TypeVector, id, scalar, (uint)size));
    }

    // A type may be declared once only.
    private uint Type(Predicate<SpirVInstruction> same, Func<uint, SpirVInstruction> declare)
    {
        SpirVInstruction? found = _module.Instructions.Find(same) ?? _declared.Find(same);
        if (found is null)
        {
            found = declare(_module.NewId());
            _declared.Add(found);
        }
        return found[0];
    }

    private uint Constant(uint type, uint bits)
    {
        if (_constants.TryGetValue((type, bits), out uint found))
        {
            return found;
        }
        (uint scalar, int size) = Shape(type);
        uint[] parts = size == 1 ? [] : [.. Enumerable.Repeat(Constant(scalar, bits), size)];
        uint id = _module.NewId();
        _declared.Add(size == 1
            ? new SpirVInstruction(SpirVOp.Constant, type, id, bits)
            : new SpirVInstruction(SpirVOp.ConstantComposite, [type, id, .. parts]));
        return _constants[(type, bits)] = id;
    }
}
