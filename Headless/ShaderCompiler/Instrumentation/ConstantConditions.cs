using Headless.Shaders.SpirV;

namespace Headless.Shaders;

/// <summary>Hides from a driver that a branch, a loop or an output hangs on constant buffers alone.</summary>
/// <remarks>
/// Mesa's lavapipe writes the values of such constants into the shader and compiles it anew each time they are set (its
/// lvp_inline_uniforms.c), and up to Mesa 23.0 it never frees what it compiled: megabytes and a tenth of a second a draw.
/// if (_Quality > 1) becomes if (never ? false : _Quality > 1), where never is a comparison that no thread passes but that no
/// compiler can decide. Loops of a fixed length stay as they are, so that compilers unroll them.
/// </remarks>
public static class ConstantConditions
{
    private const uint PrimitiveId = 7, FragCoord = 15, LocalInvocationIndex = 29, VertexIndex = 42;

    /// <summary>The same object for a shader without such a place.</summary>
    public static ShaderBinary Apply(ShaderBinary binary)
    {
        SpirVIndex index = new(new SpirVModule(binary.SpirV));
        ConstantFlow flow = new(index);
        List<SpirVInstruction> sites = [.. index.Module.Instructions.Where(flow.Decides)];
        if (sites.Count == 0)
        {
            return binary;
        }
        ModuleEditor editor = new(index);
        uint never = editor.Variable(SpirVStorage.Private, editor.Bool);
        foreach (SpirVInstruction site in sites)
        {
            int operand = site.Op == SpirVOp.Store ? 1 : 0;
            uint type = flow.TypeOf(site[operand]);
            (uint read, uint hidden) = (index.Module.NewId(), index.Module.NewId());
            Insert(index.Module, site,
            [
                new(SpirVOp.Load, editor.Bool, read, never),
                new(SpirVOp.Select, type, hidden, read, editor.Constant(SpirVOp.ConstantNull, type), site[operand]),
            ]);
            site[operand] = hidden;
        }
        List<SpirVInstruction> start = Never(binary.Stage, editor, never);
        index.Module.Instructions.InsertRange(editor.EntryStart(), start);
        byte[] bytes = index.Module.ToBytes();
        return binary with { SpirV = bytes, Hash = ShaderReflector.Hash(bytes) };
    }

    // A merge instruction stands right before its branch.
    private static void Insert(SpirVModule module, SpirVInstruction site, List<SpirVInstruction> before)
    {
        int at = module.Instructions.IndexOf(site);
        at -= module.Instructions[at - 1].Op is SpirVOp.SelectionMerge or SpirVOp.LoopMerge ? 1 : 0;
        module.Instructions.InsertRange(at, before);
    }

    // A fragment lies at x < 0, or the number of a thread, vertex or primitive is 4294967295.
    private static List<SpirVInstruction> Never(ShaderStage stage, ModuleEditor editor, uint never)
    {
        SpirVModule module = editor.Module;
        (uint input, uint x, uint result) = (module.NewId(), module.NewId(), module.NewId());
        if (stage == ShaderStage.Fragment)
        {
            uint single = editor.Type(SpirVOp.TypeFloat, 32);
            uint position = editor.BuiltInInput(FragCoord, editor.Type(SpirVOp.TypeVector, single, 4), out uint vector);
            return
            [
                new(SpirVOp.Load, vector, input, position),
                new(SpirVOp.CompositeExtract, single, x, input, 0),
                new(SpirVOp.FOrdLessThan, editor.Bool, result, x, editor.Constant(SpirVOp.ConstantNull, single)),
                new(SpirVOp.Store, never, result),
            ];
        }
        uint builtIn = stage switch { ShaderStage.Vertex => VertexIndex, ShaderStage.Geometry => PrimitiveId, _ => LocalInvocationIndex };
        uint number = editor.BuiltInInput(builtIn, editor.UInt, out uint type);
        return
        [
            new(SpirVOp.Load, type, input, number),
            new(SpirVOp.IEqual, editor.Bool, result, input, editor.Constant(uint.MaxValue)),
            new(SpirVOp.Store, never, result),
        ];
    }
}
