using System.Text.RegularExpressions;

namespace Headless.Checks.Gpu;

/// <summary>How many instructions of each class a stretch of GCN or RDNA code has.</summary>
internal sealed partial record InstructionCounts(
    int Valu, int Transcendental, int IntegerProduct, int Scalar, int Branches, int ScalarLoads, int VectorLoads, int VectorStores,
    int Atomics, int Groupshared, int Waits)
{
    public int Total => Valu + Transcendental + IntegerProduct + Scalar + Branches + ScalarLoads + VectorLoads + VectorStores
        + Atomics + Groupshared + Waits;

    public static InstructionCounts Of(IEnumerable<string> operations)
    {
        var count = operations.CountBy(ClassOf).ToDictionary();
        int N(InstructionClass key) => count.GetValueOrDefault(key);
        return new(N(InstructionClass.Valu), N(InstructionClass.Transcendental), N(InstructionClass.IntegerProduct),
            N(InstructionClass.Scalar), N(InstructionClass.Branch), N(InstructionClass.ScalarLoad), N(InstructionClass.VectorLoad),
            N(InstructionClass.VectorStore), N(InstructionClass.Atomic), N(InstructionClass.Groupshared), N(InstructionClass.Wait));
    }

    /// <exception cref="FormatException">No instruction of GCN or RDNA that is known here.</exception>
    public static InstructionClass ClassOf(string operation) => operation switch
    {
        _ when Starts(operation, "s_load", "s_buffer_load", "s_scratch_load", "s_memtime", "s_dcache") => InstructionClass.ScalarLoad,
        _ when Starts(operation, "s_waitcnt", "s_nop", "s_clause", "s_inst_prefetch", "s_delay_alu", "s_barrier", "s_sleep") => InstructionClass.Wait,
        _ when Starts(operation, "s_cbranch", "s_branch", "s_setpc", "s_swappc", "s_endpgm") => InstructionClass.Branch,
        _ when Starts(operation, "s_") => InstructionClass.Scalar,
        _ when MemoryAtomic().IsMatch(operation) => InstructionClass.Atomic,
        _ when MemoryStore().IsMatch(operation) => InstructionClass.VectorStore,
        _ when Starts(operation, "buffer_", "tbuffer_", "global_", "flat_", "scratch_", "image_") => InstructionClass.VectorLoad,
        _ when Starts(operation, "ds_") => InstructionClass.Groupshared,
        _ when Starts(operation, "exp") => InstructionClass.VectorStore,
        _ when Transcendentals().IsMatch(operation) => InstructionClass.Transcendental,
        _ when IntegerProducts().IsMatch(operation) => InstructionClass.IntegerProduct,
        _ when Starts(operation, "v_") => InstructionClass.Valu,
        _ => throw new FormatException($"'{operation}' is no instruction that is known here"),
    };

    private static bool Starts(string operation, params ReadOnlySpan<string> starts)
    {
        foreach (var start in starts)
            if (operation.StartsWith(start, StringComparison.Ordinal)) return true;
        return false;
    }

    [GeneratedRegex("^(buffer|global|flat|image)_atomic")]
    private static partial Regex MemoryAtomic();

    [GeneratedRegex("^(t?buffer|global|flat|scratch|image)_store")]
    private static partial Regex MemoryStore();

    [GeneratedRegex("^v_(rcp|rsq|sqrt|exp|log|sin|cos)_")]
    private static partial Regex Transcendentals();

    [GeneratedRegex("^v_(mul_(lo|hi)_[ui]32|mad_[ui]64_[ui]32)")]
    private static partial Regex IntegerProducts();
}
