namespace Headless.Bench.Model;

/// <summary>A GPU and what is assumed of it. Rates are the makers' data; latencies and utilisations are guesses from published microbenchmarks.</summary>
/// <param name="Family">Family of the compiled table whose code stands for its own.</param>
/// <param name="Lanes">Lanes of a wave.</param>
/// <param name="Schedulers">Schedulers that each issue one instruction a cycle.</param>
/// <param name="Hertz">Clock [1/s].</param>
/// <param name="Utilisation">Part of the issue cycles that are used when there are waves enough.</param>
/// <param name="Waves">Waves that a scheduler holds.</param>
/// <param name="FirstLoad">Cycles to the first vector load of a turn, where the next depend on it.</param>
/// <param name="NextLoad">Cycles to each further one.</param>
/// <param name="ScalarLoad">Cycles to a constant that is loaded in the loop.</param>
/// <param name="Alu">Cycles from one arithmetic instruction to one that needs it.</param>
/// <param name="CacheBytes">Bytes a second of the last cache.</param>
/// <param name="MemoryBytes">Bytes a second of the memory.</param>
/// <param name="Cache">Bytes that the last cache holds.</param>
/// <param name="Dispatch">Time of a dispatch and the barrier before it [s].</param>
/// <param name="CountsInstructions">Whether issue is counted in instructions, as NVIDIA's, and not in the family's cycles.</param>
internal sealed record NamedGpu(
    string Name, string Family, int Lanes, int Schedulers, double Hertz, double Utilisation, int Waves, double FirstLoad, double NextLoad, double ScalarLoad,
    double Alu, double CacheBytes, double MemoryBytes, double Cache, double Dispatch, bool CountsInstructions)
{
    public static IReadOnlyList<NamedGpu> All { get; } =
    [
        new("RX 6900 XT", "NAVI21", 64, 160, 2.25e9, 0.85, 16, 120, 120, 40, 5, 1.2e12, 0.42e12, 100e6, 4e-6, CountsInstructions: false),
        new("H200", "NAVI21", 32, 528, 1.7e9, 0.75, 16, 260, 70, 0, 4.5, 4e12, 3.6e12, 50e6, 2.5e-6, CountsInstructions: true),
    ];

    /// <summary>Loads of candidates lie beside each other, so on NVIDIA they hit the first cache.</summary>
    public const double CandidateLoad = 40;

    /// <summary>Issue cycles of a turn for a wave.</summary>
    public double Issue(CompiledLoop loop) => CountsInstructions
        ? loop.Valu + loop.Transcendental + loop.IntegerProduct + loop.Branches + loop.Memory + loop.Groupshared
        : loop.Cycles;

    /// <summary>Cycles of a turn if nothing else runs: its loads one after the other, and the chain of its arithmetic.</summary>
    public double Chain(CompiledLoop loop, bool gathers)
    {
        const int mostLoadsInARow = 3;
        const double dependent = 0.9;
        int loads = Math.Min(loop.Memory, mostLoadsInARow);
        double first = CountsInstructions && !gathers ? CandidateLoad : FirstLoad;
        return (loads > 0 ? first + (gathers ? (loads - 1) * NextLoad : 0) : 0) + ScalarLoad * loop.ScalarLoads + dependent * Alu * (loop.Valu + loop.Transcendental);
    }

    /// <summary>Seconds of a pass: the longer of issue and chain, and a quarter of the other while all waves fit.</summary>
    public double Time(double particles, double issue, double chain)
    {
        double waves = particles / Lanes / Schedulers;
        if (CountsInstructions && waves < Waves) waves = Math.Ceiling(waves);
        double busy = waves * issue / Utilisation, waiting = chain * Math.Max(1, waves / Waves);
        return (Math.Max(busy, waiting) + (waves < Waves ? 0.25 * Math.Min(busy, waiting) : 0)) / Hertz;
    }

    /// <summary>Seconds to move bytes.</summary>
    public double Move(double bytes) => bytes / (bytes > Cache ? MemoryBytes : CacheBytes);

    public string Assumptions => FormattableString.Invariant(
        $"{Name}: code of {Family}{(CountsInstructions ? ", an instruction a cycle without scalar ones" : "")}; {Schedulers} schedulers, waves of {Lanes}, {Hertz / 1e9:0.##} GHz, {Utilisation:P0} of the issue cycles used, ")
        + FormattableString.Invariant($"{Waves} waves each; load {FirstLoad:0} cycles, next {NextLoad:0}{(CountsInstructions ? $", candidate {CandidateLoad:0}" : "")}, constant {ScalarLoad:0}, arithmetic {Alu:0.#} of which 90 % in a chain; ")
        + FormattableString.Invariant($"cache {Cache / 1e6:0} MB at {CacheBytes / 1e12:0.##} TB/s, memory {MemoryBytes / 1e12:0.##} TB/s; dispatch with barrier {Dispatch * 1e6:0.#} us");
}
