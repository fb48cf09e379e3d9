namespace Headless.Bench.Model;

/// <summary>A GPU and what is assumed of it: a line of benchmarks/model/gpus.csv.</summary>
/// <param name="Family">Family of the compiled table whose code stands for its own.</param>
/// <param name="CountsInstructions">Whether issue is counted in instructions, as NVIDIA's, and not in the family's cycles.</param>
/// <param name="Lanes">Lanes of a wave.</param>
/// <param name="Schedulers">Schedulers that each issue one instruction a cycle to 32 lanes.</param>
/// <param name="GraphicsSchedulers">Those of them that may draw.</param>
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
/// <param name="Measured">What the names of its measured tables end in; nothing where it was not at hand.</param>
/// <param name="Maker">Which of these its maker publishes.</param>
/// <param name="Guessed">Which are guesses, and from what.</param>
internal sealed record NamedGpu(
    string Name, string Family, bool CountsInstructions, int Lanes, int Schedulers, int GraphicsSchedulers, double Hertz, double Utilisation, int Waves,
    double FirstLoad, double NextLoad, double ScalarLoad, double Alu, double CacheBytes, double MemoryBytes, double Cache, double Dispatch, string Measured,
    string Maker, string Guessed)
{
    /// <summary>Loads of candidates lie beside each other, so on NVIDIA they hit the first cache.</summary>
    public const double CandidateLoad = 40;

    private const int LanesOfAScheduler = 32;

    public static NamedGpu Of(ModelRow row) => new(
        row.Text("name"), row.Text("family"), row.Text("counts") == "instructions", row.Whole("lanes"), row.Whole("schedulers"),
        row.Whole("graphics_schedulers"), 1e9 * row.Number("ghz"),
        row.Number("utilisation"), row.Whole("waves"), row.Number("first_load"), row.Number("next_load"), row.Number("scalar_load"), row.Number("alu"),
        1e12 * row.Number("cache_tb_s"), 1e12 * row.Number("memory_tb_s"), 1e6 * row.Number("cache_mb"), 1e-6 * row.Number("dispatch_us"),
        row.Text("measured"), row.Text("maker"), row.Text("guessed"));

    /// <summary>Lanes that get an instruction in a second, and those of them that may draw.</summary>
    public double LaneRate => Schedulers * LanesOfAScheduler * Hertz * Utilisation;

    public double GraphicsLaneRate => GraphicsSchedulers * LanesOfAScheduler * Hertz * Utilisation;

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

    /// <summary>A pass: the longer of issue and chain, and a quarter of the other while all waves fit.</summary>
    public StepCost Time(double particles, double issue, double chain)
    {
        double waves = particles / Lanes / Schedulers;
        if (CountsInstructions && waves < Waves) waves = Math.Ceiling(waves);
        double busy = waves * issue / Utilisation, waiting = chain * Math.Max(1, waves / Waves);
        double seconds = (Math.Max(busy, waiting) + (waves < Waves ? 0.25 * Math.Min(busy, waiting) : 0)) / Hertz;
        return busy > waiting ? new StepCost(seconds, 0, 0, 0) : new StepCost(0, seconds, 0, 0);
    }

    /// <summary>Seconds to move bytes.</summary>
    public double Move(double bytes) => bytes / (bytes > Cache ? MemoryBytes : CacheBytes);

    public IEnumerable<string> Assumptions()
    {
        yield return FormattableString.Invariant($"{Name}: {Schedulers} schedulers{(GraphicsSchedulers < Schedulers ? $" of which {GraphicsSchedulers} draw" : "")}, ")
            + FormattableString.Invariant($"waves of {Lanes}, {Hertz / 1e9:0.###} GHz, {Utilisation:P0} of the issue ")
            + FormattableString.Invariant($"cycles used, code of {Family}{(CountsInstructions ? ", an instruction a cycle without scalar ones" : "")}; {Waves} waves each; ")
            + FormattableString.Invariant($"load {FirstLoad:0} cycles, next {NextLoad:0}{(CountsInstructions ? $", candidate {CandidateLoad:0}" : "")}, ")
            + FormattableString.Invariant($"constant {ScalarLoad:0}, arithmetic {Alu:0.#} of which 90 % in a chain; cache {Cache / 1e6:0} MB at ")
            + FormattableString.Invariant($"{CacheBytes / 1e12:0.##} TB/s, memory {MemoryBytes / 1e12:0.###} TB/s; dispatch with barrier {Dispatch * 1e6:0.#} us");
        yield return $"  maker's data: {Maker}; guessed: {Guessed}";
    }
}
