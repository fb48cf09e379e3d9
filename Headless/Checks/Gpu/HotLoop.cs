namespace Headless.Checks.Gpu;

/// <summary>A kernel whose inner loop decides the time of a step or of a surface.</summary>
/// <param name="Name">What one turn handles.</param>
internal sealed record HotLoop(string Kernel, string Name)
{
    public static IReadOnlyList<HotLoop> All { get; } =
    [
        new("StandardDensity", "candidate"),
        new("MoveParticles", "neighbour"),
        new("CalculateDensity", "candidate"),
        new("CalculateForce", "candidate"),
        new("SampleBlocks", "particle"),
    ];

    /// <summary>Of the loops that contain no other and load from buffers or groupshared memory, the one with the most instructions; null without such a loop.</summary>
    public static InstructionCounts? Find(IsaListing listing) =>
        listing.InnerLoops().Where(loop => loop.VectorLoads + loop.Groupshared > 0).MaxBy(loop => loop.Total);
}
