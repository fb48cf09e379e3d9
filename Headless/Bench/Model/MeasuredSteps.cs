namespace Headless.Bench.Model;

/// <summary>A step whose time is known, beside its estimate. Seconds.</summary>
internal sealed record HeldEstimate(string Step, double Kappa, double Particles, double Neighbours, StepCost Estimated, double Measured)
{
    public double Ratio => Measured / Estimated.Total;
}

/// <summary>Estimates of the card that was measured, each beside its measurement: the turns of the state with the neighbours of the measured liquid.</summary>
internal sealed class MeasuredSteps
{
    /// <summary>Behind the name of a mean that no run had: it follows from a rebuilt and a reused step.</summary>
    public const string Followed = " *";

    private static readonly (string Config, string Together, double Kappa)[] Standard =
        [("standard", "standard_at_once", 2), ("standard_2.25", "standard_2.25_at_once", 2.25)];

    private readonly ModelTables tables;
    private readonly IReadOnlyList<ModelRow> solver, clock;

    public MeasuredSteps(ModelTables tables)
    {
        this.tables = tables;
        solver = tables.Measured("solver");
        clock = [.. tables.Measured("model/measured").Where(r => r.Text("label") == "plain" && r.Number("timestamps") == 0)];
        Steps = [.. Listed().Concat(Thesis())];
    }

    public IReadOnlyList<HeldEstimate> Steps { get; }

    /// <summary>Of both kinds of Standard's steps, from 16,384 particles on: their means of any number lie between.</summary>
    public Doubt Doubt => Doubt.Of(
        [.. Steps.Where(s => s.Step is StepModel.Rebuilt or StepModel.Reused && s.Particles >= 16384).Select(s => s.Ratio)]);

    /// <summary>Where a rebuilt step's time goes, measured and estimated.</summary>
    public IEnumerable<HeldEstimate> Passes()
    {
        NamedGpu card = tables.Card;
        foreach ((string config, _, double kappa) in Standard)
            foreach (ModelRow row in solver.Where(r => r.Text("config") == config).OrderBy(r => r.Number("particles")))
            {
                double particles = row.Number("particles"), neighbours = row.Number("neighbours_mean"), time = 1e-3 * row.Number("gpu_ms_median");
                StepModel model = tables.Model(kappa, neighbours);
                StepCost all = model.Time(card, StepModel.Rebuilt, particles);
                StepCost density = model.Pass(card, "density", particles), motion = model.Pass(card, "force", particles);
                HeldEstimate Held(string part, StepCost estimated, double share) =>
                    new(part, kappa, particles, neighbours, estimated, share * time);
                var dispatch = new StepCost(0, 0, 0, card.Dispatch);
                StepCost rest = all + -1 * (density + motion + 2 * dispatch);
                double named = row.Number("share.sort") + row.Number("share.density") + row.Number("share.motion");
                yield return Held("sort, and between passes", rest, row.Number("share.sort") + 1 - named);
                yield return Held("density", density + dispatch, row.Number("share.density"));
                yield return Held("motion", motion + dispatch, row.Number("share.motion"));
            }
    }

    /// <summary>Seconds of a dispatch with its barrier and small work: two sorts that differ by their dispatches.</summary>
    public IEnumerable<(double Particles, double Seconds)> Dispatches() =>
        from sorted in clock.Where(r => r.Text("solver") == "thesis_27")
        from fused in clock.Where(r => r.Text("solver") == "thesis_27_fused" && r.Number("particles") == sorted.Number("particles"))
        where sorted.Number("particles") <= 65536
        orderby sorted.Number("particles")
        select (sorted.Number("particles"),
            1e-6 * (sorted.Number("us_per_step_median") - fused.Number("us_per_step_median"))
                / (sorted.Number("commands_per_step") - fused.Number("commands_per_step")));

    private IEnumerable<HeldEstimate> Listed()
    {
        foreach ((string config, string together, double kappa) in Standard)
        {
            // The bench has no 512, at which nothing but waiting and dispatches is left.
            ModelRow single = Clock(config, 512, 1), several = Clock(config, 512, 24);
            double alone = 1e-6 * single.Number("us_per_step_median"), together512 = 1e-6 * several.Number("us_per_step_median");
            foreach (HeldEstimate held in Pair(kappa, 512, single.Number("neighbours_mean"), alone, together512, 1.0 / 3)) yield return held;
            foreach (ModelRow row in solver.Where(r => r.Text("config") == config).OrderBy(r => r.Number("particles")))
            {
                double particles = row.Number("particles");
                ModelRow many = solver.First(r => r.Text("config") == together && r.Number("particles") == particles);
                foreach (HeldEstimate held in Pair(kappa, particles, row.Number("neighbours_mean"), 1e-3 * row.Number("gpu_ms_median"),
                             1e-3 * many.Number("gpu_ms_median"), many.Number("rebuilds"))) yield return held;
            }
        }
    }

    /// <summary>A step alone builds its lists; of steps together only a share does, so the others' time is what is left.</summary>
    private IEnumerable<HeldEstimate> Pair(double kappa, double particles, double neighbours, double alone, double together, double rebuilds)
    {
        StepModel model = tables.Model(kappa, neighbours);
        HeldEstimate Held(string step, StepCost estimated, double measured) => new(step, kappa, particles, neighbours, estimated, measured);
        double reused = (together - rebuilds * alone) / (1 - rebuilds);
        yield return Held(StepModel.Rebuilt, model.Time(tables.Card, StepModel.Rebuilt, particles), alone);
        yield return Held(FormattableString.Invariant($"Standard mean of {1 / rebuilds:0}"), model.Mixed(tables.Card, rebuilds, particles), together);
        yield return Held(StepModel.Reused, model.Time(tables.Card, StepModel.Reused, particles), reused);
        foreach (ModelStep mean in tables.Steps.Where(s => s.IsMean))
            yield return Held(mean.Name + Followed, model.Time(tables.Card, mean.Name, particles),
                mean.Parts().Sum(p => p.Times * (p.Step == StepModel.Rebuilt ? alone : reused)) / mean.Parts().Sum(p => p.Times));
    }

    private IEnumerable<HeldEstimate> Thesis() =>
        from pair in new[] { ("thesis_27", "Thesis 27 cells"), ("thesis_27_fused", "Thesis fused sort") }
        from row in solver
        where row.Text("config") == pair.Item1
        let particles = row.Number("particles")
        orderby pair.Item1, particles
        select new HeldEstimate(pair.Item2, row.Number("kappa"), particles, row.Number("neighbours_mean"),
            tables.Model(row.Number("kappa"), row.Number("neighbours_mean")).Time(tables.Card, pair.Item2, particles), 1e-3 * row.Number("gpu_ms_median"));

    private ModelRow Clock(string config, double particles, double together) => clock.First(r =>
        r.Text("solver") == config && r.Number("particles") == particles && r.Number("steps_together") == together);
}
