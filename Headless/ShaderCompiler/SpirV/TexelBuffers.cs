namespace Headless.Shaders.SpirV;

/// <summary>Turns texel buffers of 32-bit words, the form in which vkd3d reads Direct3D's buffers, into storage buffers.</summary>
/// <remarks>
/// "OpImageFetch %v4uint %image %word" becomes "OpAccessChain %pointer %buffer %zero %word", "OpLoad" and a vector that holds the
/// word in every place; OpImageQuerySize becomes OpArrayLength.
/// </remarks>
internal sealed class TexelBuffers
{
    private const uint BufferDimension = 5;
    private const uint Sampled = 1;

    private readonly SpirVModule _module;
    private readonly SpirVIndex _index;
    private readonly Dictionary<uint, uint> _variableOf = [];
    private uint _word, _zero, _wordPointer;

    private TexelBuffers(SpirVModule module)
    {
        _module = module;
        _index = new SpirVIndex(module);
    }

    public static void MakeStorage(SpirVModule module) => new TexelBuffers(module).Rewrite();

    private void Rewrite()
    {
        List<SpirVInstruction> variables = [.. _index.Variables.Where(IsTexelBuffer)];
        if (variables.Count == 0)
        {
            return;
        }
        uint pointer = DeclareTypes(variables);
        HashSet<uint> buffers = [];
        foreach (SpirVInstruction variable in variables)
        {
            variable[0] = pointer;
            variable[2] = (uint)SpirVStorage.Uniform;
            buffers.Add(variable[1]);
        }
        List<SpirVInstruction> rewritten = [];
        foreach (SpirVInstruction instruction in _module.Instructions)
        {
            rewritten.AddRange(Rewrite(instruction, buffers));
        }
        _module.Instructions.Clear();
        _module.Instructions.AddRange(rewritten);
    }

    private bool IsTexelBuffer(SpirVInstruction variable)
    {
        // OpTypeImage: id, sampled type, dim, depth, arrayed, multisampled, sampled, format
        SpirVInstruction type = _index.Definition(_index.Pointee(variable));
        return type.Op == SpirVOp.TypeImage && type[2] == BufferDimension && type[6] == Sampled;
    }

    // struct { uint words[]; }, before the first of the variables
    private uint DeclareTypes(List<SpirVInstruction> variables)
    {
        _word = _index.Definition(_index.Pointee(variables[0]))[1];
        SpirVInstruction word = _index.Definition(_word);
        if (word.Op != SpirVOp.TypeInt || variables.Any(v => _index.Definition(_index.Pointee(v))[1] != _word))
        {
            throw new InvalidDataException("vkd3d-compiler reads a buffer as something else than words of 32 bits");
        }
        uint array = _module.NewId(), block = _module.NewId(), pointer = _module.NewId();
        _zero = _module.NewId();
        _wordPointer = _module.NewId();
        int at = _module.Instructions.IndexOf(variables.MinBy(_module.Instructions.IndexOf)!);
        _module.Instructions.InsertRange(at,
        [
            new SpirVInstruction(SpirVOp.TypeRuntimeArray, array, _word),
            new SpirVInstruction(SpirVOp.TypeStruct, block, array),
            new SpirVInstruction(SpirVOp.TypePointer, pointer, (uint)SpirVStorage.Uniform, block),
            new SpirVInstruction(SpirVOp.TypePointer, _wordPointer, (uint)SpirVStorage.Uniform, _word),
            new SpirVInstruction(SpirVOp.Constant, _word, _zero, 0),
        ]);
        _module.Instructions.InsertRange(_index.FirstType(),
        [
            new SpirVInstruction(SpirVOp.Decorate, array, (uint)SpirVDecoration.ArrayStride, 4),
            new SpirVInstruction(SpirVOp.Decorate, block, (uint)SpirVDecoration.BufferBlock),
            new SpirVInstruction(SpirVOp.MemberDecorate, block, 0, (uint)SpirVDecoration.Offset, 0),
            new SpirVInstruction(SpirVOp.MemberDecorate, block, 0, (uint)SpirVDecoration.NonWritable),
        ]);
        return pointer;
    }

    private IEnumerable<SpirVInstruction> Rewrite(SpirVInstruction i, HashSet<uint> buffers)
    {
        switch (i.Op)
        {
            case SpirVOp.Load when buffers.Contains(i[2]):
                _variableOf[i[1]] = i[2];
                return [];
            case SpirVOp.ImageFetch when _variableOf.TryGetValue(i[2], out uint buffer):
                uint element = _module.NewId(), value = _module.NewId();
                return
                [
                    new SpirVInstruction(SpirVOp.AccessChain, _wordPointer, element, buffer, _zero, i[3]),
                    new SpirVInstruction(SpirVOp.Load, _word, value, element),
                    new SpirVInstruction(SpirVOp.CompositeConstruct, i[0], i[1], value, value, value, value),
                ];
            case SpirVOp.ImageQuerySize when _variableOf.TryGetValue(i[2], out uint buffer):
                return [new SpirVInstruction(SpirVOp.ArrayLength, i[0], i[1], buffer, 0)];
            default:
                return [i];
        }
    }
}
