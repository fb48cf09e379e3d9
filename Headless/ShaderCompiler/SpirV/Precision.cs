namespace Headless.Shaders.SpirV;

/// <summary>Makes half a float of 32 bits, as it is in FXC, by removing the leave to compute with fewer.</summary>
internal static class Precision
{
    private const uint RelaxedPrecision = 0;

    public static void MakeFull(SpirVModule module) => module.Instructions.RemoveAll(i =>
        (i.Op == SpirVOp.Decorate && i[1] == RelaxedPrecision) || (i.Op == SpirVOp.MemberDecorate && i[2] == RelaxedPrecision));
}
