using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>The part of the chart's script that is about one panel.</summary>
    internal sealed class ChartPanelScript
    {
        private const int CautionWidth = 88;
        private const double FailureRowHeight = 0.12, LabelRowHeight = 0.15; // parts of the axis
        private const double FailureHeight = 0.96; // part of the panel's height
        private const double Smallest = 1e-7;

        // 4 and 8 ms a frame at 60 Hz.
        private static readonly (double Cost, string Title)[] realTime = { (240.0, "4 ms/frame"), (480.0, "8 ms/frame") };

        private readonly ChartPanel panel;
        private readonly int index;
        private readonly ChartAxis x, y;

        public ChartPanelScript(ChartPanel panel, IReadOnlyList<ChartPanel> group, int index)
        {
            this.panel = panel;
            this.index = index;
            // One caution below all panels of the group.
            Notes = panel == group[0] ? Gnuplot.Wrap(panel.Case.Caution, CautionWidth * group.Count) : Array.Empty<string>();
            x = ChartAxis.Of(group.SelectMany(p => p.Points).Where(p => p.Cost.HasValue)
                .SelectMany(p => new[] { p.Cost.Value.Minimum, p.Cost.Value.Maximum }).Concat(realTime.Select(l => l.Cost)));
            bool failures = group.Any(p => p.Points.Any(q => q.Failures > 0));
            y = ChartAxis.Of(group.SelectMany(p => p.Points).Where(p => p.Error.HasValue)
                .SelectMany(p => new[] { Shown(p.Error.Value.Minimum), Shown(p.Error.Value.Maximum) }).Append(0.7 * panel.Case.Floor),
                LabelRowHeight, failures ? FailureRowHeight : 0.0);
        }

        /// <summary>The caution below the panel, line by line.</summary>
        public string[] Notes { get; }

        /// <summary>
        /// A block of data for each method and factor: cost, error, their least and greatest, whether it is the factor's own point, a
        /// label; and one of the failed points.
        /// </summary>
        public IEnumerable<string> Data()
        {
            foreach ((int method, ChartFactor factor) in Series())
            {
                yield return $"{Name(method, factor)} << END";
                IReadOnlyList<ChartPoint> sweep = panel.Sweep(CaseMethod.All[method], factor);
                foreach (ChartPoint p in sweep)
                {
                    SampleStatistics c = p.Cost.Value, e = p.Error.Value;
                    yield return string.Join(" ",
                        new[] { c.Median, Shown(e.Median), c.Minimum, c.Maximum, Shown(e.Minimum), Shown(e.Maximum) }
                        .Select(Gnuplot.Number).Append(factor == panel.FactorOf(p) ? "1" : "0").Append(Label(p, factor, sweep)));
                }
                yield return "END";
            }
            foreach ((int method, ChartFactor factor) in Failures())
            {
                yield return $"{Name(method, factor)}_failed << END";
                foreach (ChartPoint p in Failed(method, factor))
                {
                    yield return Gnuplot.Number(p.Cost?.Median ?? x.Low * Math.Pow(x.High / x.Low, 0.02));
                }
                yield return "END";
            }
        }

        /// <summary>The drawing commands.</summary>
        public IEnumerable<string> Drawing()
        {
            yield return "unset label; unset arrow; unset object";
            yield return x.Script("x", ChartAxis.Short);
            yield return y.Script("y", panel.IsFraction ? ChartAxis.Percent : (Func<double, string>)Gnuplot.Number);
            yield return $"set title {Gnuplot.Quote(panel.Case.Title)} font ',13' offset 0,-0.4";
            yield return $"set ylabel {Gnuplot.Quote(panel.ErrorName)}";
            foreach (string line in Marks()) yield return line;
            var layers = new List<string>();
            foreach ((int method, ChartFactor factor) in Series())
            {
                if (factor != ChartFactor.Base && factor != ChartFactor.Several)
                {
                    layers.Add($"{Name(method, factor)} using 1:2 with lines lw 1 lc {ChartStyle.Colour(method)}");
                }
            }
            // The base comes last: it lies on top.
            foreach ((int method, ChartFactor factor) in Series().OrderBy(s => s.Factor == ChartFactor.Base))
            {
                layers.Add($"{Name(method, factor)} using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt {ChartStyle.Symbol(factor)} " +
                    $"ps {ChartStyle.Size(factor)} lw 1 lc {ChartStyle.Colour(method)}");
            }
            foreach ((int method, ChartFactor factor) in Series().Where(s => s.Factor == ChartFactor.Support))
            {
                layers.Add($"{Name(method, factor)} using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc {ChartStyle.Colour(method)}");
            }
            double top = y.Low * Math.Pow(y.High / y.Low, FailureHeight);
            foreach ((int method, ChartFactor factor) in Failures())
            {
                layers
                    .Add($"{Name(method, factor)}_failed using 1:({Gnuplot.Number(top)}) with points pt {ChartStyle.OpenSymbol(factor)} " +
                    $"ps {ChartStyle.Size(factor)} lw 1.5 lc {ChartStyle.Colour(method)}");
            }
            // The axes alone, where no run has this error: an older version's table may have it under another name.
            yield return "plot " + (layers.Count > 0 ? string.Join(", \\\n    ", layers) : "1/0");
        }

        // A wider support costs more a step and allows longer ones: which end of its line is which is not to be guessed.
        private string Label(ChartPoint point, ChartFactor factor, IReadOnlyList<ChartPoint> sweep)
        {
            bool end = factor == ChartFactor.Support && (point == sweep[0] || point == sweep[sweep.Count - 1]);
            return end && factor == panel.FactorOf(point) ? "\"" + Gnuplot.Number(point.SupportRatio) + "\"" : "\"\"";
        }

        private IEnumerable<string> Marks()
        {
            if (panel.Case.Floor > 0.0)
            {
                string floor = Gnuplot.Number(panel.Case.Floor);
                yield return $"set object 1 rectangle from graph 0, graph 0 to graph 1, first {floor} fc rgb '#E6E6E6' fs solid 1.0 " +
                    "noborder behind";
                // In the row that the axis leaves free below the points.
                yield return $"set label 1 {Gnuplot.Quote("reference floor " + ChartAxis.Percent(Math.Round(panel.Case.Floor, 4)))} at " +
                    "graph 0.985, graph 0.04 right " +
                    "font ',9' tc rgb '#707070'";
            }
            for (int i = 0; i < realTime.Length; i++)
            {
                string cost = Gnuplot.Number(realTime[i].Cost);
                yield return $"set arrow {i + 1} from {cost}, graph 0 to {cost}, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back";
                yield return $"set label {i + 2} {Gnuplot.Quote(realTime[i].Title)} at {cost}, graph 0.02 left rotate by 90 offset 1.3,0 " +
                    "font ',9' tc rgb '#707070'";
            }
            for (int i = 0; i < Notes.Length; i++)
            {
                yield return $"set label {i + 10} {Gnuplot.Quote(Notes[i])} at graph 0, graph 0 left offset " +
                    $"-5,{(-3.6 - i).ToString(CultureInfo.InvariantCulture)} " +
                    "font ',9' tc rgb '#404040'";
            }
        }

        private IEnumerable<(int Method, ChartFactor Factor)> Series() =>
            Combinations().Where(s => panel.Sweep(CaseMethod.All[s.Method], s.Factor).Count > 0);

        private IEnumerable<(int Method, ChartFactor Factor)> Failures() => Combinations().Where(s => Failed(s.Method, s.Factor).Any());

        private IEnumerable<ChartPoint> Failed(int method, ChartFactor factor) =>
            panel.Points.Where(p => p.Failures > 0 && p.Method == CaseMethod.All[method].Name && panel.FactorOf(p) == factor);

        private static IEnumerable<(int Method, ChartFactor Factor)> Combinations() =>
            from m in Enumerable.Range(0, CaseMethod.All.Count) from f in ChartStyle.Factors select (m, f.Factor);

        private string Name(int method, ChartFactor factor) => $"$p{index}_{method}_{factor}";

        // A logarithmic axis has no zero.
        private static double Shown(double error) => Math.Max(Smallest, error);
    }
}
