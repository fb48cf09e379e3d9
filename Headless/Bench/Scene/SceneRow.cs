namespace Headless.Bench.Scene;

/// <summary>A build in a span of the scene; times and numbers are for a simulated second.</summary>
internal sealed class SceneRow
{
    // The device makes its kernels in these: no part of what a second costs.
    private const int WarmUp = 2;

    public SceneRow(SceneOptions options, PacedPlayer player, ScenePhase phase, PacedPlayer? other)
    {
        (Player, Phase) = (player, phase);
        Numbers = [.. player.Frames.Keys.Where(f => f > WarmUp && phase.Has(f, options.Fps) && (other is null || other.Frames.ContainsKey(f))).Order()];
        Scale = options.Fps / Math.Max(1, Numbers.Count);
        Solver = Sum(f => f.Time(PassGroup.Solver));
        Surface = Sum(f => f.Time(PassGroup.Surface));
        Drawing = Sum(f => f.Time(PassGroup.Drawing));
        Steps = Sum(f => f.Steps);
        // Whatever orders particles anew scans the cells once, or ranks those with particles.
        Rebuilds = Sum(f => f.Times("ScanCells") + f.Times("RankCells"));
        Dispatches = Sum(f => f.Dispatches ?? double.NaN);
        Processor = Sum(f => f.Processor);
        if (other is null) return;
        ProcessorRatio = RatioTo(other, f => f.Processor);
        SolverRatio = RatioTo(other, f => f.Time(PassGroup.Solver));
        SurfaceRatio = RatioTo(other, f => f.Time(PassGroup.Surface));
        DrawingRatio = RatioTo(other, f => f.Time(PassGroup.Drawing));
    }

    public PacedPlayer Player { get; }
    public ScenePhase Phase { get; }
    public IReadOnlyList<int> Numbers { get; }
    public double Solver { get; }
    public double Surface { get; }
    public double Drawing { get; }
    public double Steps { get; }
    public double Rebuilds { get; }
    public double Dispatches { get; }
    public double Processor { get; }
    public Ratio ProcessorRatio { get; set; } = Ratio.None;
    public Ratio SolverRatio { get; set; } = Ratio.None;
    public Ratio SurfaceRatio { get; set; } = Ratio.None;
    public Ratio DrawingRatio { get; set; } = Ratio.None;

    private double Scale { get; }

    private double Sum(Func<PlayedFrame, double> value) => Scale * Numbers.Sum(n => value(Player.Frames[n]));

    private Ratio RatioTo(PacedPlayer other, Func<PlayedFrame, double> value) =>
        Ratio.Of([.. Numbers.Select(n => (value(Player.Frames[n]), value(other.Frames[n])))]);
}
