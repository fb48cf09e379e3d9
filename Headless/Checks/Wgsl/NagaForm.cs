using Headless.Shaders;
using Headless.Shaders.SpirV;

namespace Headless.Checks.Wgsl;

/// <summary>SPIR-V in the form that naga reads: it says the same as before.</summary>
internal static class NagaForm
{
    private const int LogicalOr = 166, LogicalAnd = 167, Select = 169, TypeVector = 23;

    public static byte[] Of(byte[] spirV, ShaderStage stage)
    {
        var module = new SpirVModule(spirV);
        SelectInPlaceOfVectorLogic(module);
        OneTypeInSums(module);
        DescriptorNumbers.Assign(new SpirVIndex(module), stage == ShaderStage.Fragment ? 2 : 0);
        return module.ToBytes();
    }

    // a && b is a ? b : a, component by component; naga has && and || of scalars.
    private static void SelectInPlaceOfVectorLogic(SpirVModule module)
    {
        var vectors = module.Instructions.Where(i => (int)i.Op == TypeVector).Select(i => i[0]).ToHashSet();
        for (var at = 0; at < module.Instructions.Count; at++)
        {
            var i = module.Instructions[at];
            if ((int)i.Op is not (LogicalOr or LogicalAnd) || !vectors.Contains(i[0])) continue;
            var (then, otherwise) = (int)i.Op == LogicalAnd ? (i[3], i[2]) : (i[2], i[3]);
            module.Instructions[at] = new SpirVInstruction((SpirVOp)Select, i[0], i[1], i[2], then, otherwise);
        }
    }

    // SPIR-V adds and shifts signed and unsigned numbers as one, as glslang does for the addresses of ByteAddressBuffer.Load2 to Load4; naga does not.
    private static void OneTypeInSums(SpirVModule module)
    {
        var types = module.Instructions.Where(IsNumber).ToDictionary(i => i[1], i => i[0]);
        for (var at = 0; at < module.Instructions.Count; at++)
        {
            var i = module.Instructions[at];
            if ((int)i.Op is not (128 or 130 or 132 or >= 194 and <= 199)) continue; // +, -, *, shifts, |, ^, &
            for (var operand = 2; operand < ((int)i.Op <= 196 && (int)i.Op >= 194 ? 3 : 4); operand++) // a shift is by any number
            {
                if (!types.TryGetValue(i[operand], out var type) || type == i[0]) continue;
                var cast = module.NewId();
                module.Instructions.Insert(at++, new SpirVInstruction(SpirVOp.Bitcast, i[0], cast, i[operand]));
                i[operand] = cast;
            }
        }
    }

    // Constants, loads, parts of vectors, conversions, arithmetic, atomics, phi: result type, then result.
    private static bool IsNumber(SpirVInstruction i) =>
        i.Op is SpirVOp.Constant or SpirVOp.Load or SpirVOp.Phi || (int)i.Op is >= 79 and <= 84 or >= 109 and <= 205 or >= 229 and <= 242;
}
