namespace Headless.Checks.Fxc;

/// <summary>What a user waits for and what small devices are short of: length of each program, work of its compilation, number of the product's compute variants, shared memory.</summary>
internal sealed class FxcBudget(string packageRoot)
{
    /// <summary>Instruction slots of a program. FXC's time grows with them, and unlike its time they are the same on every machine.</summary>
    public const int MaxSlots = 1350;

    /// <summary>
    /// Memory that FXC asks for while it compiles a program. Loops that are unrolled and folded again leave few slots and much work: a program of
    /// 842 slots takes as long as others of 1,500. The time follows this figure as well, with a correlation of 0.94 over 355 programs. Most is
    /// GatherWalls among bodies that stretch.
    /// </summary>
    public const int MaxKilobytes = 140_000;

    public const int MaxVariants = 221, MaxSharedBytes = 16 * 1024;

    // What Unity imports with the product and compiles for a player; tests' kernels stay in the source tree.
    private const string Shipped = "Shaders/";

    /// <summary>Kernels with more shared memory than Vulkan and OpenGL ES 3.1 promise, each with the reason.</summary>
    private static readonly Dictionary<string, string> largeGroups = [];

    /// <summary>Kernels with more slots, each with the reason.</summary>
    private static readonly Dictionary<string, int> longKernels = new()
    {
        // The share of each plane is taken for walls, friction, floating bodies, zones and the force on walls, in one loop over what is near;
        // the gradient correction adds two products of matrices to each pair.
        ["MoveParticles"] = 2420,
        // Planes of three turns, sums over edges with their Hessian, no more than half-spaces have; far triangles passed over; bodies that
        // stretch and float.
        ["GatherWalls"] = 2640,
        ["ResolveContacts"] = 1830, // four kinds of bodies; those that deform are followed through a step; rectangles by the area they cover
        // A cell is found in a table of all or of those with particles, by each of the two that search.
        ["ConstrainDensity"] = 1400,
        ["MoveByConstraints"] = 1410,
        // 27 samples a thread in registers through nested loops, two filters.
        ["SampleBlocks"] = 1600,
        // Light is followed to the scene, mirrored by panes and carried on behind; the scene's picture may be coarser than its depth.
        ["ShadeWater"] = 1450,
    };

    public void Check(IReadOnlyList<FxcResult> results, CheckReport report)
    {
        var kernels = results.Where(r => r.Job.IsKernel).ToList();
        foreach (var result in results.Where(r => r.Slots > Allowed(r)))
            report.Findings.Add($"{result.Job.Name}: {result.Slots} instruction slots, {Allowed(result)} are allowed: the first Play waits for FXC");
        foreach (var result in results.Where(r => r.Kilobytes > MaxKilobytes))
            report.Findings.Add($"{result.Job.Name}: FXC asks for {result.Kilobytes} KB to compile it, {MaxKilobytes} are allowed: the first Play waits for it. Unroll less, or nest fewer loops");
        foreach (var most in kernels.Where(r => longKernels.ContainsKey(r.Job.Entry)).GroupBy(r => r.Job.Entry, (entry, of) => (Entry: entry, Slots: of.Max(r => r.Slots))).Where(m => m.Slots <= MaxSlots))
            report.Findings.Add($"{most.Entry}: {most.Slots} instruction slots at most need no exception");
        foreach (var result in kernels.Where(r => r.SharedBytes > MaxSharedBytes && !largeGroups.ContainsKey(r.Job.Entry)))
            report.Findings.Add($"{result.Job.Name}: {result.SharedBytes} bytes of groupshared memory, Vulkan and OpenGL ES 3.1 promise {MaxSharedBytes}");
        var variants = kernels.Count(r => IsShipped(r.Job.File));
        if (variants > MaxVariants) report.Findings.Add($"{variants} compute variants, {MaxVariants} are allowed: let numbers switch what a keyword does not make faster");
        if (kernels.Count == 0) return;
        FxcResult longest = results.MaxBy(r => r.Slots)!, largest = results.MaxBy(r => r.Kilobytes)!, slowest = results.MaxBy(r => r.Milliseconds)!;
        report.Figures += $"; {variants} compute variants, at most {longest.Slots} instruction slots ({longest.Job.Name}), {largest.Kilobytes} KB to compile one ({largest.Job.Name}), longest compilation {slowest.Milliseconds / 1000.0:F2} s "
            + $"of CPU time ({slowest.Job.Name}), all {results.Sum(r => r.Milliseconds) / 1000.0:F0} s; largest: {kernels.Max(r => r.Threads)} threads, {kernels.Max(r => r.Buffers)} buffers, "
            + $"{kernels.Max(r => r.Uavs)} written, {kernels.Max(r => r.SharedBytes)} bytes shared";
    }

    private static int Allowed(FxcResult result) => longKernels.GetValueOrDefault(result.Job.Entry, MaxSlots);

    private bool IsShipped(string file)
    {
        var path = Path.GetRelativePath(packageRoot, file).Replace('\\', '/');
        return path.StartsWith(Shipped, StringComparison.Ordinal);
    }
}
