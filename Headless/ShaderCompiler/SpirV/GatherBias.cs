namespace Headless.Shaders.SpirV;

/// <summary>
/// Takes the bias from gathers: HLSL has none, but glslang writes the value that GatherCmp compares with as one, which Vulkan refuses without
/// an extension of AMD's.
/// </summary>
internal static class GatherBias
{
    private const uint Bias = 1; // of the image operands' mask, the first of which it is
    private const uint Capability = 5009; // ImageGatherBiasLodAMD
    private const string Extension = "SPV_AMD_texture_gather_bias_lod";
    private const int Mask = 5; // operands: type, result, image, place, component or depth, mask

    public static void Remove(SpirVModule module)
    {
        foreach (SpirVInstruction i in module.Instructions)
        {
            if (i.Op is SpirVOp.ImageGather or SpirVOp.ImageDrefGather && i.Operands.Length > Mask && (i[Mask] & Bias) != 0)
            {
                uint rest = i[Mask] & ~Bias;
                uint[] others = i.Operands[(Mask + 2)..];
                i.Operands = rest == 0 ? i.Operands[..Mask] : [.. i.Operands[..Mask], rest, .. others];
            }
        }
        module.Instructions.RemoveAll(i => (i.Op == SpirVOp.Capability && i[0] == Capability) || (i.Op == SpirVOp.Extension && i.Text(0) == Extension));
    }
}
