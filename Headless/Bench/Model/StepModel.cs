using System.Globalization;

namespace Headless.Bench.Model;

/// <summary>Which loops a pass has: a line of benchmarks/model/loops.csv.</summary>
/// <param name="PerTurn">Candidates or neighbours that a turn takes.</param>
/// <param name="Gathers">Whether its loads go where a list says.</param>
/// <param name="Share">Part of the waves that go through it.</param>
internal sealed record PassLoop(string Pass, string Kernel, string Keywords, string Loop, bool OverNeighbours, double PerTurn, bool Gathers, double Share);

/// <summary>A step: a line of benchmarks/model/steps.csv.</summary>
/// <param name="Passes">Names of its passes; or, with a number before each as "1 rebuilt", of steps that it is the mean of.</param>
/// <param name="Dispatches">Dispatches at 65,536 and 1,048,576 particles.</param>
/// <param name="SortBytes">Bytes a particle that are moved besides the passes.</param>
/// <param name="ListBytes">Bytes a particle of the list, written and read, at κ = 2.</param>
/// <param name="MeasuredListBytes">The same, as it was when the card was measured.</param>
internal sealed record ModelStep(
    string Name, string[] Passes, double[] Dispatches, double SortBytes, double ListBytes, double MeasuredListBytes)
{
    public bool IsMean => char.IsAsciiDigit(Passes[0][0]);

    /// <summary>Sorts take more dispatches with each doubling.</summary>
    public double DispatchesAt(double particles) =>
        Math.Max(1, Dispatches[0] + (Dispatches[1] - Dispatches[0]) * Math.Log2(particles / 65536) / Math.Log2(1048576 / 65536));

    /// <summary>The steps of a mean, and how many of each.</summary>
    public IEnumerable<(double Times, string Step)> Parts() =>
        Passes.Select(part => part.Split(' ', 2)).Select(words => (double.Parse(words[0], CultureInfo.InvariantCulture), words[1]));
}

/// <summary>Times of steps of a liquid on GPUs that are not at hand, from compiled loops and the turns that waves take through them.</summary>
/// <param name="waves">By lanes of a wave.</param>
/// <param name="listScale">Entries of a list beside those of κ = 2.</param>
internal sealed class StepModel(
    CompiledLoops compiled, IReadOnlyList<PassLoop> loops, IReadOnlyList<ModelStep> steps, IReadOnlyDictionary<int, WaveStatistics> waves, double listScale)
{
    public const string Rebuilt = "Standard rebuilt", Reused = "Standard reused";

    // Finding a row of cells: two loads behind each other and their arithmetic.
    private const double RowCycles = 45, RowInstructions = 40, RowChain = 255;

    // Bits of a chunk of 32 candidates, put right and stored; rows have about 27, so a chunk each.
    private const double ChunkCycles = 60, ChunkInstructions = 26, ChunkChain = 100;

    // Small passes of a step besides, and the part of a pass's time that hides the list's traffic.
    private const double SmallPasses = 4e-6, HiddenByWork = 0.5;

    public static string Assumptions => FormattableString.Invariant(
        $"a row of cells {RowCycles:0} cycles (AMD) or {RowInstructions:0} instructions (NVIDIA), {RowChain:0} cycles if nothing else runs, in chunks ")
        + FormattableString.Invariant($"{ChunkCycles:0}, {ChunkInstructions:0} and {ChunkChain:0} more; small passes {SmallPasses * 1e6:0} us up to 65,536 ")
        + "particles; half of a pass's time hides the list's bytes; gathers of neighbours (32 bytes each) hit the first caches; no walls, no tail of a pass.";

    /// <summary>Bytes a particle that a step moves beyond the first caches.</summary>
    public double Bytes(ModelStep step) => step.IsMean ? Mean(step, Bytes) : SortBytes(step) + ListBytes(step);

    public double SortBytes(ModelStep step) => step.IsMean ? Mean(step, SortBytes) : step.SortBytes;

    public double ListBytes(ModelStep step) => step.IsMean ? Mean(step, ListBytes) : listScale * step.ListBytes;

    /// <summary>Bytes a particle of neighbours' positions and velocities that the passes of a step load, most of them from the first caches.</summary>
    public double GatheredBytes(ModelStep step)
    {
        const double position = 16, velocity = 16;
        if (step.IsMean) return Mean(step, GatheredBytes);
        double neighbours = waves.Values.First().Neighbours;
        return step.Passes.Sum(pass => pass.EndsWith("force", StringComparison.Ordinal) ? neighbours * (position + velocity) : neighbours * position);
    }

    public StepCost Time(NamedGpu gpu, string step, double particles) => Time(gpu, Step(step), particles);

    public StepCost Time(NamedGpu gpu, ModelStep step, double particles)
    {
        if (step.IsMean)
        {
            StepCost sum = default;
            double count = 0;
            foreach ((double times, string part) in step.Parts())
            {
                sum += times * Time(gpu, Step(part), particles);
                count += times;
            }
            return 1 / count * sum;
        }
        StepCost work = default;
        foreach (string pass in step.Passes) work += Pass(gpu, pass, particles);
        double list = Math.Max(0, gpu.Move(ListBytes(step) * particles) - HiddenByWork * work.Total);
        return work + new StepCost(
            0, 0, gpu.Move(step.SortBytes * particles) + list, step.DispatchesAt(particles) * gpu.Dispatch + (particles <= 65536 ? SmallPasses : 0));
    }

    /// <summary>A step of which a share builds its lists anew.</summary>
    public StepCost Mixed(NamedGpu gpu, double rebuilds, double particles) =>
        rebuilds * Time(gpu, Rebuilt, particles) + (1 - rebuilds) * Time(gpu, Reused, particles);

    /// <summary>A pass without its dispatch and its bytes.</summary>
    public StepCost Pass(NamedGpu gpu, string pass, double particles)
    {
        double issue = 0, chain = 0;
        bool searches = false, inChunks = false;
        foreach (PassLoop loop in loops.Where(l => l.Pass == pass))
        {
            double turns = loop.Share * Turns(gpu, loop);
            issue += turns * gpu.Issue(Compiled(gpu, loop));
            chain += turns * gpu.Chain(Compiled(gpu, loop), loop.Gathers);
            searches |= !loop.OverNeighbours;
            inChunks |= !loop.OverNeighbours && loop.PerTurn > 1;
        }
        double rows = waves[gpu.Lanes].Rows;
        if (searches)
        {
            issue += rows * (gpu.CountsInstructions ? RowInstructions : RowCycles);
            chain += rows * RowChain;
        }
        if (inChunks)
        {
            issue += rows * (gpu.CountsInstructions ? ChunkInstructions : ChunkCycles);
            chain += rows * ChunkChain;
        }
        return gpu.Time(particles, issue, chain);
    }

    /// <summary>Turns of a wave through a loop of a pass, and cycles of one turn.</summary>
    public (double Turns, double Issue, double Chain) Turn(NamedGpu gpu, PassLoop loop) =>
        (loop.Share * Turns(gpu, loop), gpu.Issue(Compiled(gpu, loop)), gpu.Chain(Compiled(gpu, loop), loop.Gathers));

    private double Mean(ModelStep step, Func<ModelStep, double> of) =>
        step.Parts().Sum(part => part.Times * of(Step(part.Step))) / step.Parts().Sum(part => part.Times);

    private ModelStep Step(string name) => steps.FirstOrDefault(s => s.Name == name) ?? throw new UsageException($"benchmarks/model/steps.csv has no step '{name}'.");

    private double Turns(NamedGpu gpu, PassLoop loop)
    {
        WaveStatistics wave = waves[gpu.Lanes];
        // A row's last turn takes what is left of it.
        double rest = (loop.PerTurn - 1) / 2 * (loop.OverNeighbours ? 1 : wave.Rows);
        return ((loop.OverNeighbours ? wave.NeighbourTurns : wave.CandidateTurns) + rest) / loop.PerTurn;
    }

    private CompiledLoop Compiled(NamedGpu gpu, PassLoop loop) => compiled[gpu.Family, loop.Kernel, loop.Keywords, loop.Loop];
}
