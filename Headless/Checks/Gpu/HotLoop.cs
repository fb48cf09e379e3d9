namespace Headless.Checks.Gpu;

/// <summary>A kernel whose inner loop decides the time of a step or of a surface.</summary>
/// <param name="Name">What one turn handles.</param>
internal sealed record HotLoop(string Kernel, string Name)
{
    public static IReadOnlyList<HotLoop> All { get; } =
    [
        new("StandardDensity", "candidate"),
        new("ListedDensity", "neighbour"),
        new("MoveParticles", "neighbour"),
        new("CalculateDensity", "candidate"),
        new("CalculateForce", "candidate"),
        new("SampleBlocks", "particle"),
        new("GatherWalls", "triangle"),
        new("FindContacts", "triangle"),
        new("Reorder", "particle of the cell"),
        new("PrepareSurfaceParticles", "neighbour"),
        new("EmitBlocks", "vertex"),
        new("BitonicSort", "compare"),
        new("FusedBitonicSort", "compare"),
    ];

    /// <summary>
    /// The loops that contain no other and read buffers or groupshared memory, in the order of the code. The one with the most instructions
    /// has the kernel's name for a turn, the others are "inner 1", "inner 2" and so on.
    /// </summary>
    public IEnumerable<(string Name, InstructionCounts Counts)> Find(IsaListing listing)
    {
        var loops = listing.InnerLoops().Where(loop => loop.VectorLoads + loop.Groupshared > 0).ToList();
        // As long as one reads buffers, those that do not are asides.
        var main = loops.Where(loop => loop.VectorLoads > 0).DefaultIfEmpty(loops.MaxBy(loop => loop.Total)).MaxBy(loop => loop?.Total ?? 0);
        var others = 0;
        foreach (var loop in loops) yield return (ReferenceEquals(loop, main) ? Name : $"inner {++others}", loop);
    }
}
