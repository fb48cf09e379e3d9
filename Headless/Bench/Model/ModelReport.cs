using System.Globalization;

namespace Headless.Bench.Model;

/// <summary>The estimates as lines for people.</summary>
internal sealed class ModelReport
{
    private const double DefaultKappa = 2.25;

    private static readonly double[] Sizes = [65536, 262144, 1048576];

    private readonly ModelTables tables;
    private readonly MeasuredSteps measured;
    private readonly FrameParts parts;

    public ModelReport(ModelTables tables)
    {
        this.tables = tables;
        measured = new MeasuredSteps(tables);
        parts = new FrameParts(tables, measured.Doubt.OfRatios);
    }

    public IEnumerable<string> Lines() => Assumptions().Append("")
        .Concat(PassLines()).Append("").Concat(Held()).Append("").Concat(StepLines()).Append("")
        .Concat(Bytes()).Append("").Concat(PartLines()).Append("").Concat(BudgetLines());

    private IEnumerable<string> Assumptions()
    {
        yield return $"Estimates but for columns named measured: loops compiled by {tables.Compiler}; turns of {tables.State}:";
        foreach (double kappa in tables.Kappas)
            foreach (WaveStatistics w in tables.Waves(kappa))
                yield return Text($"  κ {kappa}, waves of {w.Lanes}: {w.Candidates:0.0} candidates and {w.Neighbours:0.0} neighbours a lane; ")
                    + Text($"{w.CandidateTurns:0.0} and {w.NeighbourTurns:0.0} turns, {w.Rows:0.0} rows");
        foreach (string line in tables.Gpus.SelectMany(gpu => gpu.Assumptions())) yield return "  " + line;
        yield return "  " + StepModel.Assumptions;
        foreach (PassLoop loop in tables.Loops)
            yield return Text($"  {loop.Pass}: loop '{loop.Loop}' of {loop.Kernel}, {loop.PerTurn:0} {(loop.OverNeighbours ? "neighbours" : "candidates")} ")
                + Text($"a turn, in {loop.Share:P0} of the waves{(loop.Gathers ? ", loads where a list says" : "")}");
    }

    private IEnumerable<string> Passes => tables.Loops.Select(l => l.Pass).Distinct();

    private IEnumerable<string> PassLines()
    {
        yield return $"{"pass, us",-20}{"κ",-6}{"GPU",-27}{"turns a wave",14}{"issue/turn",12}{"chain/turn",12}{SizeHead(15)}";
        // The thesis's step has no κ but 2.
        foreach (double kappa in tables.Kappas)
            foreach (string pass in Passes.Where(p => kappa == DefaultKappa != p.StartsWith("thesis", StringComparison.Ordinal)))
                foreach (NamedGpu gpu in tables.Gpus)
                {
                    StepModel model = tables.Model(kappa);
                    var turns = tables.Loops.Where(l => l.Pass == pass).Select(l => model.Turn(gpu, l)).ToArray();
                    string Joined(Func<(double Turns, double Issue, double Chain), string> of) => string.Join('+', turns.Select(of));
                    yield return Text($"{pass,-20}{kappa,-6}{gpu.Name,-27}{Joined(t => Text($"{t.Turns:0.0}")),14}")
                        + $"{Joined(t => Text($"{t.Issue:0}")),12}{Joined(t => Text($"{t.Chain:0}")),12}"
                        + string.Concat(Sizes.Select(n => Cell(model.Pass(gpu, pass, n), 15)));
                }
    }

    private IEnumerable<string> Held()
    {
        yield return $"Held against {tables.Card.Name} ({tables.Card.Measured}), us; turns through neighbours scaled to those of the measured box at rest:";
        yield return HeldHead("step");
        foreach (HeldEstimate held in measured.Steps) yield return HeldLine(held);
        yield return "* as measured for a rebuilt and a reused step; a reused one is what three steps together took besides their rebuilt one.";
        yield return HeldHead("part of a rebuilt step");
        foreach (HeldEstimate held in measured.Passes()) yield return HeldLine(held);
        Doubt doubt = measured.Doubt;
        yield return Text($"Doubt: measured steps of Standard, rebuilt and reused, from 16,384 particles on, take {doubt.Low:0.00} to {doubt.High:0.00} ")
            + "times their estimates.";
        yield return "No measured row is bound by memory, so where memory bounds an estimate the doubt is borrowed.";
        string dispatches = string.Join(", ", measured.Dispatches().Select(d => Text($"{1e6 * d.Seconds:0.0} us with {d.Particles:N0} particles")));
        yield return $"A dispatch with barrier and its small work, from the thesis's two sorts: {dispatches}; assumed "
            + Text($"{1e6 * tables.Card.Dispatch:0.0} us.");
    }

    private IEnumerable<string> StepLines()
    {
        Doubt doubt = measured.Doubt;
        yield return $"Estimates times doubt, for {tables.State}; in brackets what bounds the estimate:";
        yield return $"{"step, us",-21}{"κ",-6}{"GPU",-27}{SizeHead(26)}";
        foreach (double kappa in tables.Kappas)
            foreach (ModelStep step in tables.Steps.Where(s => kappa == 2 || !s.Name.StartsWith("Thesis", StringComparison.Ordinal)))
                foreach (NamedGpu gpu in tables.Gpus)
                    yield return Text($"{step.Name,-21}{kappa,-6}{gpu.Name,-27}") + string.Concat(Sizes.Select(n =>
                    {
                        StepCost cost = tables.Model(kappa).Time(gpu, step, n);
                        return $"{Range(1e6 * cost.Total * doubt.Low, 1e6 * cost.Total * doubt.High) + $" ({cost.Bound})",26}";
                    }));
    }

    private IEnumerable<string> Bytes()
    {
        yield return $"{"bytes a particle, step",-26}{"κ",-6}{"sort",8}{"list",8}{"beyond first caches",21}{"gathered, mostly from first caches",36}";
        foreach (double kappa in tables.Kappas)
            foreach (ModelStep step in tables.Steps.Where(s => s.Name.StartsWith("Standard", StringComparison.Ordinal)))
            {
                StepModel model = tables.Model(kappa);
                yield return Text($"{step.Name,-26}{kappa,-6}{model.SortBytes(step),8:0}{model.ListBytes(step),8:0}{model.Bytes(step),21:0}")
                    + Text($"{model.GatheredBytes(step),36:0}");
            }
    }

    private IEnumerable<string> PartLines()
    {
        yield return $"Surface and drawing of water at 1280 x 720, whitewater: measured on {tables.Card.Name}, on the line through both measured sizes. Others:";
        yield return "what no particle adds to by the ratio of the clocks, what they add by the ratio of issued lanes (graphics: of those that draw) or of dispatches,";
        yield return Text($"divided and multiplied by {parts.Off:0.00}; drawing at most no shorter than on {tables.Card.Name}.");
        yield return $"{"part, us",-21}{"bound",-12}{"GPU",-27}{SizeHead(20)}";
        foreach (FramePart part in tables.FrameParts)
            foreach (NamedGpu gpu in tables.Gpus)
                yield return $"{part.Name,-21}{part.Resource,-12}{gpu.Name,-27}" + string.Concat(Sizes.Select(n => PartCell(gpu, parts.Seconds(part, gpu, n))));
        foreach (NamedGpu gpu in tables.Gpus)
            yield return $"{"all but whitewater",-21}{"",-12}{gpu.Name,-27}" + string.Concat(Sizes.Select(n => PartCell(gpu, parts.Frame(gpu, n))));
    }

    private string PartCell(NamedGpu gpu, (double Low, double High) seconds) =>
        $"{(gpu == tables.Card ? Text($"{1e6 * seconds.Low:0} measured") : Range(1e6 * seconds.Low, 1e6 * seconds.High)),20}";

    private IEnumerable<string> BudgetLines()
    {
        yield return Text($"Thousands of particles at 60 frames a second: steps, surface and drawing within {1e3 * FrameBudget.Seconds:0} ms, κ {DefaultKappa}:");
        yield return $"{"GPU",-27}" + string.Concat(FrameSteps.All.Select(s => $"{Text($"{s.Name}, {s.At16K} steps at 16 K"),32}"));
        var budget = new FrameBudget(tables.Model(DefaultKappa), parts);
        foreach (NamedGpu gpu in tables.Gpus)
            yield return $"{gpu.Name,-27}" + string.Concat(FrameSteps.All.Select(s =>
            {
                (double low, double high) = budget.Particles(gpu, s, measured.Doubt);
                return $"{(high > 0 ? Range(low / 1e3, high / 1e3) : "none"),32}";
            }));
        yield return "Steps of a frame grow with N^(1/3); in motion every fourth step builds its lists, calm every eighth. Left out: queries, corrected steps,";
        yield return "meshes as walls, bodies, whitewater, the scene's own drawing, and the processor's time.";
    }

    private static string SizeHead(int width) => string.Concat(Sizes.Select(n => $"{(n >= 1048576 ? "1 M" : Text($"{n / 1024:0} K")).PadLeft(width)}"));

    private static string Cell(StepCost cost, int width) => $"{Text($"{1e6 * cost.Total:0.0} {cost.Bound}")}".PadLeft(width);

    private static string HeldHead(string what) => $"{what,-26}{"κ",-6}{"particles",10}{"neighbours",12}{"estimated",11}{"measured",10}{"ratio",7}  bound";

    private static string HeldLine(HeldEstimate held) =>
        Text($"{held.Step,-26}{held.Kappa,-6}{held.Particles,10:0}{held.Neighbours,12:0.0}{1e6 * held.Estimated.Total,11:0.0}")
        + Text($"{1e6 * held.Measured,10:0.0}{held.Ratio,7:0.00}  {held.Estimated.Bound}");

    // Two digits are all that such estimates bear.
    private static string Range(double low, double high) => Text($"{Rounded(low)} to {Rounded(high)}");

    private static double Rounded(double value)
    {
        if (value <= 0) return 0;
        double digit = Math.Pow(10, Math.Floor(Math.Log10(value)) - 1);
        return Math.Round(Math.Round(value / digit) * digit, 6);
    }

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
