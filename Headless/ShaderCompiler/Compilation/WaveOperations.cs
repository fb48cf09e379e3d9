using System.Text.RegularExpressions;
using Headless.Shaders.SpirV;

namespace Headless.Shaders;

/// <summary>Wave and quad intrinsics: Shader Model 6, so unknown to FXC and to Direct3D 11.</summary>
internal static partial class WaveOperations
{
    private const uint InclusiveScan = 1;
    private const uint ExclusiveScan = 2;

    /// <summary>Whether the source asks for DXC, which knows Shader Model 6: "#pragma use_dxc".</summary>
    public static bool Allowed(StageJob job) => job.Source.Pragmas.Any(pragma => pragma.Words[0] == "use_dxc");

    /// <exception cref="ShaderCompileException">FXC's error X3004 for the first of them that the stage uses.</exception>
    public static void Check(StageJob job, SpirVModule module)
    {
        if (Allowed(job) || !module.Instructions.Exists(
            i => i.Op is >= SpirVOp.GroupNonUniformElect and <= SpirVOp.GroupNonUniformQuadSwap))
        {
            return;
        }
        HlslToken call = HlslTokens.Read(job.Text).Find(token => Name().IsMatch(token.Text));
        (string file, int line) = SourceLines.Position(job, call.Start);
        throw new ShaderCompileException(
            file, line,
            $"undeclared identifier '{call.Text}' at {job.Owner}: FXC, which compiles for Direct3D 11, has no wave operations "
            + "(Shader Model 6); \"#pragma use_dxc\" names the compiler that has them");
    }

    /// <summary>WavePrefixSum and the like leave out the lane's own value; glslang 12 takes it in.</summary>
    public static void MakePrefixesExclusive(SpirVModule module)
    {
        // Operands: result type, result, scope, operation, value.
        foreach (SpirVInstruction i in module.Instructions)
        {
            bool scans = i.Op is SpirVOp.GroupNonUniformBallotBitCount
                or >= SpirVOp.GroupNonUniformIAdd and <= SpirVOp.GroupNonUniformLogicalXor;
            if (scans && i[3] == InclusiveScan)
            {
                i[3] = ExclusiveScan;
            }
        }
    }

    [GeneratedRegex(@"^(Wave[A-Z]\w*|QuadRead\w+)$")]
    private static partial Regex Name();
}
