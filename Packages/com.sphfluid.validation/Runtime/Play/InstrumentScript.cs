using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>The gnuplot script of a record's instruments: a panel a quantity, over the liquid's time.</summary>
    internal sealed class InstrumentScript : GnuplotScript
    {
        private const int PanelHeight = 260;

        private static readonly string[] Colours = { "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000" };

        private readonly List<List<InstrumentCurve>> panels;

        /// <param name="stem">Name of the script and its pictures without ending.</param>
        /// <param name="curves">What was read.</param>
        public InstrumentScript(string stem, IEnumerable<InstrumentCurve> curves) : base(stem, "svg", "png")
        {
            panels = curves.Where(c => c.Points.Any(p => !double.IsNaN(p.Value))).GroupBy(c => c.Quantity).Select(g => g.ToList()).ToList();
        }

        /// <summary>Whether nothing was read.</summary>
        public bool IsEmpty => panels.Count == 0;

        private protected override IEnumerable<string> Body()
        {
            List<InstrumentCurve> all = panels.SelectMany(p => p).ToList();
            IEnumerable<string> blocks = all.SelectMany((curve, i) => Block($"$curve{i}", curve.Points.Where(p => !double.IsNaN(p.Value))
                .Select(p => $"{Gnuplot.Number(p.Time)} {Gnuplot.Number(p.Value)}")));
            return blocks.Concat(InSvgAndPng($"900,{60 + PanelHeight * panels.Count}", 13, 10, Drawing(all)));
        }

        private IEnumerable<string> Drawing(List<InstrumentCurve> all)
        {
            yield return $"set multiplot layout {panels.Count},1";
            yield return "set grid lt 1 lc rgb '#E8E8E8' lw 0.7";
            yield return "set border 3 lc rgb '#404040'";
            yield return "set tics nomirror";
            yield return "set lmargin 11";
            yield return "set rmargin 28"; // the panels stand below each other whatever their numbers and names
            yield return "set key outside right top Left reverse";
            yield return "set xlabel 'time of the liquid [s]'";
            foreach (List<InstrumentCurve> panel in panels)
            {
                yield return $"set ylabel {Gnuplot.Quote($"{Title(panel[0])} [{panel[0].Unit}]")}";
                yield return Plot(panel.Select((curve, i) =>
                    $"$curve{all.IndexOf(curve)} using 1:2 with lines lw 1.5 lc rgb '{Colours[i % Colours.Length]}' dt " +
                    $"{1 + i / Colours.Length} title {Gnuplot.Quote(curve.Instrument)}"));
            }
            yield return "unset multiplot";
        }

        // peak_pressure_pa: peak pressure.
        private static string Title(InstrumentCurve curve)
        {
            string unit = "_" + curve.Unit.Replace("³", "3").Replace("/", "_").ToLowerInvariant();
            string name = curve.Quantity.EndsWith(unit, System.StringComparison.Ordinal)
                ? curve.Quantity.Substring(0, curve.Quantity.Length - unit.Length) : curve.Quantity;
            return name.Replace('_', ' ');
        }
    }
}
