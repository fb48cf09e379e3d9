namespace Headless.Shaders.SpirV;

/// <summary>
/// Gives a % b of signed integers the sign of a, as HLSL and FXC have it (-7 % 2 is -1): glslang writes OpSMod, which has
/// the sign of b. Written out as a - a / b * b, since Vulkan leaves OpSRem of negative numbers undefined.
/// </summary>
internal static class Remainders
{
    public static void Truncate(SpirVModule module)
    {
        for (int at = 0; at < module.Instructions.Count; at++)
        {
            SpirVInstruction i = module.Instructions[at];
            if (i.Op != SpirVOp.SMod)
            {
                continue;
            }
            (uint type, uint quotient, uint product) = (i[0], module.NewId(), module.NewId());
            module.Instructions[at] = new SpirVInstruction(SpirVOp.SDiv, type, quotient, i[2], i[3]);
            module.Instructions.Insert(++at, new SpirVInstruction(SpirVOp.IMul, type, product, quotient, i[3]));
            module.Instructions.Insert(++at, new SpirVInstruction(SpirVOp.ISub, type, i[1], i[2], product));
        }
    }
}
