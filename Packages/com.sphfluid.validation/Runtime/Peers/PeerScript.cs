using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>The picture of errors against time of another program and of the chart's methods, a panel for each case.</summary>
    internal sealed class PeerScript : GnuplotScript
    {
        private const string Stem = "peers";
        private const int PanelWidth = 560, PanelHeight = 400, TitleHeight = 90, Columns = 2;

        private readonly List<IGrouping<string, PeerComparison>> panels;
        private readonly string device, chartDevice;

        /// <summary>A picture.</summary>
        /// <param name="lines">The points.</param>
        /// <param name="device">Processor and threads of the other program.</param>
        /// <param name="chartDevice">Graphics device of the chart.</param>
        public PeerScript(IEnumerable<PeerComparison> lines, string device, string chartDevice) : base(Stem, "svg", "png")
        {
            panels = lines.Where(l => l.Error > 0.0 && l.Milliseconds > 0.0).GroupBy(l => l.Case).ToList();
            this.device = device;
            this.chartDevice = chartDevice;
        }

        /// <summary>Script and pictures.</summary>
        public static IEnumerable<ResultFile> Files() => Files(Stem, "svg", "png");

        private protected override IEnumerable<string> Body()
        {
            int rows = Math.Max(1, (panels.Count + Columns - 1) / Columns);
            return Data().Concat(InSvgAndPng($"{Columns * PanelWidth},{rows * PanelHeight + TitleHeight}", 12, 9, Drawing(rows)));
        }

        private IEnumerable<string> Data() => panels.SelectMany((panel, i) => Curves(panel).SelectMany((curve, k) =>
            Block(Name(i, k), curve.Select(p => Gnuplot.Number(p.Milliseconds) + " " + Gnuplot.Number(p.Error)))));

        private IEnumerable<string> Drawing(int rows)
        {
            string title = $"Error against time: PySPH by the clock on {device};\\nmethods of the package on {chartDevice}";
            yield return $"set multiplot layout {rows},{Columns} rowsfirst title \"{title.Replace("\"", "'")}\" font ',13'";
            yield return "set logscale xy; set tmargin 2.5; set rmargin 2.5; set lmargin 10; set bmargin 4; set border 31 lc rgb " +
                "'#404040'; set tics nomirror";
            yield return "set grid xtics ytics lt 1 lc rgb '#E8E8E8' lw 0.7; set key bottom left samplen 2; set xlabel 'ms per simulated " +
                "second' offset 0,0.4";
            for (int i = 0; i < panels.Count; i++)
            {
                ChartAxis x = ChartAxis.Of(panels[i].Select(p => p.Milliseconds)),
                    y = ChartAxis.Of(panels[i].Select(p => p.Error), below: 0.45);
                yield return x.Script("x", ChartAxis.Short);
                yield return y.Script("y", ChartAxis.Percent);
                yield return $"set title {Gnuplot.Quote(PeerCase.All.First(c => c.Case.Name == panels[i].Key).Case.Title)}";
                yield return $"set ylabel {Gnuplot.Quote(panels[i].First().ErrorName)}";
                int panel = i;
                yield return Plot(Curves(panels[i]).Select((curve, k) =>
                    $"{Name(panel, k)} using 1:2 with linespoints lw 1.5 pt {(curve.First().IsOurs ? 7 : 9)} ps 1.3 lc " +
                    $"{ColourOf(curve.First().Method)} title {Gnuplot.Quote(curve.Key)}"));
            }
            yield return "unset multiplot";
        }

        // Other spacings of the same constants are joined.
        private static IEnumerable<IGrouping<string, PeerComparison>> Curves(IEnumerable<PeerComparison> panel) =>
            panel.OrderByDescending(p => p.Spacing)
                .GroupBy(p => p.IsOurs ? p.Method : FormattableString.Invariant($"{p.Method}, c = {p.SoundSpeedRatio:0.##} U"));

        private static string ColourOf(string method)
        {
            int known = CaseMethod.All.Select(m => m.Name).ToList().IndexOf(method);
            return ChartStyle.Colour(known >= 0 ? known : CaseMethod.All.Count);
        }

        private static string Name(int panel, int curve) => FormattableString.Invariant($"$p{panel}_{curve}");
    }
}
