namespace Headless.Shaders.SpirV;

/// <summary>
/// Gives a % b and fmod(a, b) the sign of a, as HLSL and FXC have it (-7 % 2 is -1, fmod(-5.5, 2) is -1.5): glslang writes
/// OpSMod and OpFMod, which have the sign of b.
/// </summary>
/// <remarks>
/// Of integers: a - a / b * b, since Vulkan leaves OpSRem of negative numbers undefined. Of floats: b * (q - trunc(q)) with
/// q = a / b, to the bit what FXC makes of fmod: b times the fraction of |q| with the sign of q. Of % it takes a * (1 / b) for q.
/// </remarks>
internal static class Remainders
{
    private const uint Trunc = 3; // of GLSL.std.450

    public static void Truncate(SpirVModule module)
    {
        for (int at = 0; at < module.Instructions.Count; at++)
        {
            SpirVInstruction i = module.Instructions[at];
            if (i.Op is not (SpirVOp.SMod or SpirVOp.FMod))
            {
                continue;
            }
            List<SpirVInstruction> written = i.Op == SpirVOp.SMod ? OfIntegers(module, i) : OfFloats(module, i);
            at = module.Instructions.IndexOf(i);
            module.Instructions.RemoveAt(at);
            module.Instructions.InsertRange(at, written);
            at += written.Count - 1;
        }
    }

    private static List<SpirVInstruction> OfIntegers(SpirVModule module, SpirVInstruction i)
    {
        (uint type, uint quotient, uint product) = (i[0], module.NewId(), module.NewId());
        return
        [
            new SpirVInstruction(SpirVOp.SDiv, type, quotient, i[2], i[3]),
            new SpirVInstruction(SpirVOp.IMul, type, product, quotient, i[3]),
            new SpirVInstruction(SpirVOp.ISub, type, i[1], i[2], product),
        ];
    }

    private static List<SpirVInstruction> OfFloats(SpirVModule module, SpirVInstruction i)
    {
        (uint type, uint quotient, uint whole, uint fraction) = (i[0], module.NewId(), module.NewId(), module.NewId());
        return
        [
            new SpirVInstruction(SpirVOp.FDiv, type, quotient, i[2], i[3]),
            new SpirVInstruction(SpirVOp.ExtInst, type, whole, Functions(module), Trunc, quotient),
            new SpirVInstruction(SpirVOp.FSub, type, fraction, quotient, whole),
            new SpirVInstruction(SpirVOp.FMul, type, i[1], i[3], fraction),
        ];
    }

    /// <summary>The import of GLSL.std.450; one is added after the capabilities where there is none.</summary>
    private static uint Functions(SpirVModule module)
    {
        const string name = "GLSL.std.450";
        if (module.Instructions.Find(i => i.Op == SpirVOp.ExtInstImport && i.Text(1) == name) is { } found)
        {
            return found[0];
        }
        uint id = module.NewId();
        uint[] words = new uint[(name.Length / 4) + 1];
        Buffer.BlockCopy(System.Text.Encoding.ASCII.GetBytes(name), 0, words, 0, name.Length);
        int after = module.Instructions.FindLastIndex(i => i.Op is SpirVOp.Capability or SpirVOp.Extension) + 1;
        module.Instructions.Insert(after, new SpirVInstruction(SpirVOp.ExtInstImport, [id, .. words]));
        return id;
    }
}
