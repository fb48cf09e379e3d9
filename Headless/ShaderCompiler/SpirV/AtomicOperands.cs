namespace Headless.Shaders.SpirV;

/// <summary>
/// Gives atomics operands of the type of their result: for InterlockedAdd(uint, 1) glslang 12 leaves a signed constant,
/// which the SPIR-V validator refuses.
/// </summary>
internal static class AtomicOperands
{
    public static void Repair(SpirVModule module)
    {
        Dictionary<uint, uint> types = [];
        for (int at = 0; at < module.Instructions.Count; at++)
        {
            SpirVInstruction i = module.Instructions[at];
            if (i.Op == SpirVOp.Constant || HasTypedResult(i.Op))
            {
                types[i[1]] = i[0];
            }
            if (i.Op is not (>= SpirVOp.AtomicExchange and <= SpirVOp.AtomicXor) || i.Operands.Length < 6)
            {
                continue;
            }
            for (int operand = OperandAfterSemantics(i); operand < i.Operands.Length; operand++)
            {
                if (types.TryGetValue(i[operand], out uint type) && type != i[0])
                {
                    uint cast = module.NewId();
                    module.Instructions.Insert(at++, new SpirVInstruction(SpirVOp.Bitcast, i[0], cast, i[operand]));
                    i[operand] = cast;
                }
            }
        }
    }

    // OpAtomicCompareExchange (230) and its weak form (231) have two memory semantics.
    private static int OperandAfterSemantics(SpirVInstruction atomic) => (ushort)atomic.Op is 230 or 231 ? 6 : 5;

    // Loads, composite extraction, conversions, arithmetic, bit operations, atomics and phi: result type, then result id.
    private static bool HasTypedResult(SpirVOp op) =>
        op is SpirVOp.Load || (ushort)op is >= 79 and <= 84 or >= 109 and <= 205 or >= 229 and <= 242 or 245;
}
