namespace Headless.Shaders.SpirV;

/// <summary>Forbids a driver to join or reorder floating-point arithmetic: it then runs to the letter.</summary>
/// <remarks>
/// FXC has done what it may do with what the source does not call precise, and vkd3d does not pass on what is precise. Where FXC joined
/// a product and a sum stands an Fma; it stays one.
/// </remarks>
internal static class Contractions
{
    public static void Forbid(SpirVModule module)
    {
        List<SpirVInstruction> decorations =
        [
            .. module.Instructions.Where(i => IsArithmetic(i.Op))
                .Select(i => new SpirVInstruction(SpirVOp.Decorate, i[1], (uint)SpirVDecoration.NoContraction)),
        ];
        module.Instructions.InsertRange(new SpirVIndex(module).FirstType(), decorations);
    }

    // OpFNegate, OpFAdd, OpFSub, OpFMul, OpFDiv, OpFRem, OpFMod, OpVectorTimesScalar, OpDot
    private static bool IsArithmetic(SpirVOp op) => (ushort)op is 127 or 129 or 131 or 133 or 136 or 140 or 141 or 142 or 148;
}
