namespace Headless.Checks.Gpu;

/// <summary>A generation of GPUs that Mesa's RADV compiles for without having one.</summary>
/// <param name="Name">What RADV_FORCE_FAMILY takes.</param>
/// <param name="Valu">Issue cycles of a vector instruction of a wave of 64 lanes.</param>
/// <param name="Slow">Those of a transcendental (rcp, sqrt, sin, ...) or a 32-bit integer product.</param>
/// <param name="Memory">Those of a vector memory or groupshared instruction.</param>
internal sealed record GpuFamily(string Name, int Valu, int Slow, int Memory)
{
    /// <summary>
    /// RDNA 2 and 3 (two halves of 32 lanes) and GCN (four quarters of 16). Every Mesa since 20.3 knows the names but GFX1100, which is
    /// NAVI31 from 23.0 on; there that family is skipped.
    /// </summary>
    public static IReadOnlyList<GpuFamily> All { get; } =
        [new("NAVI21", 2, 8, 2), new("POLARIS10", 4, 16, 4), new("GFX1100", 2, 8, 2), new("VEGA20", 4, 16, 4)];

    /// <summary>VALU issue cycles of one turn of a loop; scalar instructions are issued beside them.</summary>
    public int Cycles(InstructionCounts counts) =>
        (Valu * counts.Valu) + (Slow * (counts.Transcendental + counts.IntegerProduct)) +
        (Memory * (counts.VectorLoads + counts.VectorStores + counts.Atomics + counts.Groupshared));
}
