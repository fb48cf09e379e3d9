namespace Headless.Checks.Fxc;

/// <summary>What a user waits for and what small devices are short of: time of each compilation, number of the product's compute variants, shared memory.</summary>
internal sealed class FxcBudget(string packageRoot)
{
    public const int MaxMilliseconds = 2000, MaxVariants = 190, MaxSharedBytes = 16 * 1024;

    /// <summary>How much longer than allowed a compilation fails: machines differ by this much even after scaling by the yardstick (4.0 to 4.2 s for one kernel
    /// where the yardstick took 240 to 400 ms). In between it is a note.</summary>
    public const double Uncertainty = 1.25;

    // What Unity imports with the product and compiles for a player; tests' kernels stay in the source tree.
    private const string Shipped = "Shaders/";

    /// <summary>Kernels with more shared memory than Vulkan and OpenGL ES 3.1 promise, each with the reason.</summary>
    private static readonly Dictionary<string, string> largeGroups = [];

    /// <summary>Kernels that take longer to compile, in milliseconds, each with the reason.</summary>
    private static readonly Dictionary<string, int> slowKernels = new()
    {
        // 27 samples a thread in registers through nested loops: half the time of a row of 13 where it was measured. 4.7 s on a quiet
        // machine; on a busy one 6.9 s by the yardstick, whose share of memory traffic is another.
        ["SampleBlocks"] = 10000,
        // With meshes three loops over the cells around or a list: the search, and twice what is behind a face.
        ["StandardDensity"] = 4000,
        // The search beside walls of meshes, as in StandardDensity: 2.2 s.
        ["ConstrainDensity"] = 4000,
        ["ConstrainListed"] = 4000, // twice what is behind a face, over a list: 2.4 s
        ["MeasureDensity"] = 4000, // the same search, for readers: 2.0 s
        // With bodies that float the share of each plane is taken a second time, beside walls, friction and zones: 1.7 to 2.0 s; with the force on walls 3.2 s.
        ["MoveParticles"] = 4000,
        ["ResolveContacts"] = 4000, // four variants; the one of bodies that deform and float takes 2.1 s, on a busy machine up to 3.0 s
    };

    public void Check(IReadOnlyList<FxcResult> results, CheckReport report)
    {
        var kernels = results.Where(r => r.Job.IsKernel).ToList();
        foreach (var result in results.Where(IsSlow))
        {
            var texts = result.Milliseconds > Uncertainty * Allowed(result) ? report.Findings : report.Notes;
            texts.Add($"{result.Job.Name}: FXC took {result.Milliseconds / 1000.0:F1} s of CPU time at 2.5 GHz, {Allowed(result) / 1000} are allowed: the first Play waits for it");
        }
        foreach (var result in kernels.Where(r => r.SharedBytes > MaxSharedBytes && !largeGroups.ContainsKey(r.Job.Entry)))
            report.Findings.Add($"{result.Job.Name}: {result.SharedBytes} bytes of groupshared memory, Vulkan and OpenGL ES 3.1 promise {MaxSharedBytes}");
        var variants = kernels.Count(r => IsShipped(r.Job.File));
        if (variants > MaxVariants) report.Findings.Add($"{variants} compute variants, {MaxVariants} are allowed: let numbers switch what a keyword does not make faster");
        if (kernels.Count == 0) return;
        var slowest = results.MaxBy(r => r.Milliseconds)!;
        report.Figures += $"; {variants} compute variants, longest compilation {slowest.Milliseconds / 1000.0:F2} s of CPU time at 2.5 GHz ({slowest.Job.Name})"
            + $", all {results.Sum(r => r.Milliseconds) / 1000.0:F0} s; largest: {kernels.Max(r => r.Threads)} threads, {kernels.Max(r => r.Buffers)} buffers, "
            + $"{kernels.Max(r => r.Uavs)} written, {kernels.Max(r => r.SharedBytes)} bytes shared";
    }

    /// <summary>Whether a compilation took longer than its kernel may.</summary>
    public static bool IsSlow(FxcResult result) => result.Milliseconds > Allowed(result);

    private static int Allowed(FxcResult result) => slowKernels.GetValueOrDefault(result.Job.Entry, MaxMilliseconds);

    private bool IsShipped(string file)
    {
        var path = Path.GetRelativePath(packageRoot, file).Replace('\\', '/');
        return path.StartsWith(Shipped, StringComparison.Ordinal);
    }
}
