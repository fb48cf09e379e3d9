namespace Headless.Shaders.SpirV;

/// <summary>What a module says of a kernel besides its resources.</summary>
internal static class KernelFacts
{
    /// <summary>Threads of a group; zeros for a stage that has no groups.</summary>
    public static (int X, int Y, int Z) GroupSize(SpirVIndex index)
    {
        SpirVInstruction? mode = Mode(index, SpirVExecutionMode.LocalSize);
        return mode is null ? (0, 0, 0) : ((int)mode[2], (int)mode[3], (int)mode[4]);
    }

    /// <summary>Bytes of groupshared memory.</summary>
    public static int SharedBytes(SpirVIndex index, D3DLayout layout) => index.Variables
        .Where(v => (SpirVStorage)v[2] == SpirVStorage.Workgroup)
        .Sum(v => layout.Size(index.Pointee(v), constant: false, rowMajor: true));

    public static SpirVInstruction? Mode(SpirVIndex index, SpirVExecutionMode mode) => index.Module.Instructions.FirstOrDefault(
        i => i.Op == SpirVOp.ExecutionMode && (SpirVExecutionMode)i[1] == mode);
}
