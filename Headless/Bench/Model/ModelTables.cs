namespace Headless.Bench.Model;

/// <summary>What the model reads: benchmarks/model and the table of compiled loops.</summary>
internal sealed class ModelTables
{
    private const double ListKappa = 2;

    private readonly string folder;
    private readonly IReadOnlyList<ModelRow> waveRows;
    private readonly CompiledLoops compiled;

    /// <exception cref="UsageException">A table is missing or not understood.</exception>
    public ModelTables(string root)
    {
        folder = Path.Combine(root, "benchmarks");
        compiled = CompiledLoops.Read(Path.Combine(root, "Headless/Checks/Gpu/Data/loops.csv"));
        waveRows = Table("waves.csv");
        Gpus = [.. Table("gpus.csv").Select(NamedGpu.Of)];
        Loops = [.. Table("loops.csv").Select(r => new PassLoop(
            r.Text("pass"), r.Text("kernel"), r.Text("keywords"), r.Text("loop"), r.Text("turns") == "neighbours", r.Number("per_turn"),
            r.Text("gathers") == "yes", r.Number("share")))];
        Steps = [.. Table("steps.csv").Select(r => new ModelStep(
            r.Text("step"), r.Text("passes").Split('+'), [r.Number("dispatches_64k"), r.Number("dispatches_1m")],
            r.Number("sort_bytes"), r.Number("list_bytes"),
            r.Number("list_bytes_measured")))];
        FrameParts = [.. Table("frame-parts.csv").Select(r => new FramePart(
            r.Text("part"), r.Text("config"), r.Text("column"), r.Text("resource"), r.Text("in_frame") == "yes"))];
        Card = Gpus.FirstOrDefault(g => g.Measured.Length > 0) ?? throw new UsageException("benchmarks/model/gpus.csv has no card that was measured.");
    }

    public string Compiler => compiled.Compiler;

    public IReadOnlyList<NamedGpu> Gpus { get; }

    /// <summary>The card that was measured.</summary>
    public NamedGpu Card { get; }

    public IReadOnlyList<PassLoop> Loops { get; }

    public IReadOnlyList<ModelStep> Steps { get; }

    public IReadOnlyList<FramePart> FrameParts { get; }

    public IEnumerable<double> Kappas => waveRows.Select(r => r.Number("kappa")).Distinct();

    public string State => FormattableString.Invariant($"{waveRows[0].Text("state")}, {waveRows[0].Whole("particles")} particles");

    /// <summary>A table as the bench wrote it, of the card that was measured.</summary>
    public IReadOnlyList<ModelRow> Measured(string bench) => ModelTable.Read(Path.Combine(folder, $"{bench}-{Card.Measured}.csv"));

    public IEnumerable<WaveStatistics> Waves(double kappa) => waveRows.Where(r => r.Number("kappa") == kappa).Select(r => new WaveStatistics(
        r.Whole("lanes"), r.Number("candidates"), r.Number("neighbours"), r.Number("candidate_turns"), r.Number("rows"), r.Number("neighbour_turns")));

    /// <param name="neighbours">Of a liquid that was measured, with the lists of then; 0 for the state's, with those of now.</param>
    /// <exception cref="UsageException">The state was not evaluated with this κ.</exception>
    public StepModel Model(double kappa, double neighbours = 0)
    {
        var waves = Waves(kappa).ToDictionary(w => w.Lanes);
        if (waves.Count == 0) throw new UsageException(FormattableString.Invariant($"benchmarks/model/waves.csv has no κ = {kappa}."));
        double scale = neighbours > 0 ? neighbours / waves.Values.First().Neighbours : 1;
        foreach ((int lanes, WaveStatistics w) in waves.ToArray())
            waves[lanes] = w with { Neighbours = scale * w.Neighbours, NeighbourTurns = scale * w.NeighbourTurns };
        double listed = Waves(ListKappa).First().Neighbours;
        IReadOnlyList<ModelStep> steps = neighbours > 0 ? [.. Steps.Select(s => s with { ListBytes = s.MeasuredListBytes })] : Steps;
        return new StepModel(compiled, Loops, steps, waves, waves.Values.First().Neighbours / listed);
    }

    private IReadOnlyList<ModelRow> Table(string name) => ModelTable.Read(Path.Combine(folder, "model", name));
}
