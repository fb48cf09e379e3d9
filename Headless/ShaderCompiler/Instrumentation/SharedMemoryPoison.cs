using Headless.Shaders.SpirV;

namespace Headless.Shaders;

/// <summary>Makes a kernel begin with every bit of its groupshared memory set: NaN as a float, 4294967295 as a uint.</summary>
/// <remarks>
/// D3D11 leaves groupshared memory undefined at the start of a group. An array is written by all threads of the group, one
/// element each in turn; a barrier ends the writing.
/// </remarks>
public static class SharedMemoryPoison
{
    private const uint LocalInvocationIndex = 29;
    private const uint WorkgroupScope = 2;
    private const uint AcquireReleaseWorkgroupMemory = 0x108;

    /// <summary>The same object for a shader without groupshared memory.</summary>
    public static ShaderBinary Apply(ShaderBinary binary)
    {
        if (binary.Stage != ShaderStage.Compute || binary.SharedBytes == 0)
        {
            return binary;
        }
        SpirVIndex index = new(new SpirVModule(binary.SpirV));
        ModuleEditor editor = new(index);
        uint poison = editor.AddFunction(Body(index, editor, (uint)(binary.GroupX * binary.GroupY * binary.GroupZ)));
        index.Module.Instructions.Insert(editor.EntryStart(), editor.Call(poison));
        byte[] bytes = index.Module.ToBytes();
        return binary with { SpirV = bytes, Hash = ShaderReflector.Hash(bytes) };
    }

    private static List<SpirVInstruction> Body(SpirVIndex index, ModuleEditor editor, uint groupSize)
    {
        SpirVModule module = index.Module;
        uint label = module.NewId();
        uint first = module.NewId();
        List<SpirVInstruction> body =
        [
            new(SpirVOp.Label, label),
            new(SpirVOp.Load, editor.UInt, first, editor.BuiltInInput(LocalInvocationIndex)),
        ];
        foreach (SpirVInstruction variable in index.Variables.Where(v => (SpirVStorage)v[2] == SpirVStorage.Workgroup).ToList())
        {
            uint type = index.Pointee(variable);
            SpirVInstruction definition = index.Definition(type);
            if (definition.Op == SpirVOp.TypeArray)
            {
                label = Loop(body, index, editor, variable[1], definition, first, label, groupSize);
            }
            else
            {
                body.Add(new(SpirVOp.Store, variable[1], Ones(index, editor, type)));
            }
        }
        uint scope = editor.Constant(WorkgroupScope);
        body.Add(new(SpirVOp.ControlBarrier, scope, scope, editor.Constant(AcquireReleaseWorkgroupMemory)));
        body.Add(new(SpirVOp.Return));
        return body;
    }

    /// <summary>for (i = thread; i &lt; length; i += groupSize) array[i] = ones; returns the label after it.</summary>
    private static uint Loop(
        List<SpirVInstruction> body, SpirVIndex index, ModuleEditor editor, uint array, SpirVInstruction type, uint first,
        uint before, uint groupSize)
    {
        SpirVModule module = index.Module;
        (uint header, uint inside, uint next, uint after) = (module.NewId(), module.NewId(), module.NewId(), module.NewId());
        (uint i, uint increased, uint more, uint element) = (module.NewId(), module.NewId(), module.NewId(), module.NewId());
        uint pointer = editor.Pointer(SpirVStorage.Workgroup, type[1]);
        body.AddRange(
        [
            new(SpirVOp.Branch, header),
            new(SpirVOp.Label, header),
            new(SpirVOp.Phi, editor.UInt, i, first, before, increased, next),
            new(SpirVOp.ULessThan, editor.Bool, more, i, editor.Constant(index.ArrayLength(type))),
            new(SpirVOp.LoopMerge, after, next, 0),
            new(SpirVOp.BranchConditional, more, inside, after),
            new(SpirVOp.Label, inside),
            new(SpirVOp.AccessChain, pointer, element, array, i),
            new(SpirVOp.Store, element, Ones(index, editor, type[1])),
            new(SpirVOp.Branch, next),
            new(SpirVOp.Label, next),
            new(SpirVOp.IAdd, editor.UInt, increased, i, editor.Constant(groupSize)),
            new(SpirVOp.Branch, header),
            new(SpirVOp.Label, after),
        ]);
        return after;
    }

    private static uint Ones(SpirVIndex index, ModuleEditor editor, uint type)
    {
        SpirVInstruction definition = index.Definition(type);
        return definition.Op switch
        {
            SpirVOp.TypeBool => editor.Constant(SpirVOp.ConstantTrue, type),
            SpirVOp.TypeInt or SpirVOp.TypeFloat => editor.Constant(SpirVOp.Constant, type, Words(definition[1])),
            SpirVOp.TypeVector or SpirVOp.TypeMatrix => Composite(Enumerable.Repeat(definition[1], (int)definition[2])),
            SpirVOp.TypeArray => Composite(Enumerable.Repeat(definition[1], (int)index.ArrayLength(definition))),
            SpirVOp.TypeStruct => Composite(definition.Operands.Skip(1)),
            _ => throw new InvalidDataException($"groupshared memory of a type with opcode {definition.Op}"),
        };

        uint Composite(IEnumerable<uint> parts) =>
            editor.Constant(SpirVOp.ConstantComposite, type, [.. parts.Select(part => Ones(index, editor, part))]);
    }

    private static uint[] Words(uint bits) =>
        bits == 64 ? [uint.MaxValue, uint.MaxValue] : [bits == 32 ? uint.MaxValue : (1u << (int)bits) - 1];
}
