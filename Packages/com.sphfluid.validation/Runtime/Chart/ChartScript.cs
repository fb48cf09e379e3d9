using System.Collections.Generic;
using System.Linq;
using System.Text;

namespace SphFluid.Validation
{
    /// <summary>The gnuplot script of the whole chart, with its data: it draws accuracy.svg and accuracy.png in its folder.</summary>
    public sealed class ChartScript : GnuplotScript
    {
        private const string Stem = "accuracy";
        private const int PanelWidth = 620, PanelHeight = 470, TitleHeight = 60;
        private const int MostPanelsInTwoColumns = 5;

        private readonly IReadOnlyList<IReadOnlyList<ChartPanel>> groups;
        private readonly string device;
        private readonly string date;

        /// <summary>A chart.</summary>
        /// <param name="groups">The panels; those of a group stand side by side and have the same range of errors.</param>
        /// <param name="device">The graphics device.</param>
        /// <param name="date">Day of the last run.</param>
        public ChartScript(IReadOnlyList<IReadOnlyList<ChartPanel>> groups, string device, string date) : base(Stem, "svg", "png")
        {
            this.groups = groups;
            this.device = device;
            this.date = date;
        }

        /// <summary>Script and pictures.</summary>
        internal static IEnumerable<ResultFile> Files() => Files(Stem, "svg", "png");

        private protected override IEnumerable<string> Body()
        {
            int columns = groups.Sum(g => g.Count) > MostPanelsInTwoColumns ? 3 : 2;
            List<List<ChartPanel>> rows = Rows(columns);
            var drawings = new Dictionary<ChartPanel, ChartPanelScript>();
            foreach (IReadOnlyList<ChartPanel> group in groups)
            {
                foreach (ChartPanel panel in group) drawings.Add(panel, new ChartPanelScript(panel, group, drawings.Count));
            }
            return groups.SelectMany(g => g).SelectMany(p => drawings[p].Data())
                .Concat(InSvgAndPng($"{columns * PanelWidth},{rows.Count * PanelHeight + TitleHeight}", 13, 10,
                    Drawing(rows, columns, drawings)));
        }

        private IEnumerable<string> Drawing(List<List<ChartPanel>> rows, int columns, Dictionary<ChartPanel, ChartPanelScript> drawings)
        {
            yield return $"set multiplot layout {rows.Count},{columns} rowsfirst title " +
                $"{Gnuplot.Quote($"Error against GPU time. {device}, {date}")}.\"\\n \" font ',15'";
            foreach (string line in Settings) yield return line;
            foreach (List<ChartPanel> row in rows)
            {
                int notes = row.Count == 0 ? 0 : row.Max(p => p == null ? 0 : drawings[p].Notes.Length);
                yield return $"set bmargin {4 + notes}";
                foreach (string line in row.SelectMany(p => p == null ? new[] { "set multiplot next" } : drawings[p].Drawing()))
                {
                    yield return line;
                }
            }
            foreach (string line in Legend()) yield return line;
            yield return "unset multiplot";
        }

        private static readonly string[] Settings =
        {
            "set logscale xy", "set tmargin 2.5", "set rmargin 2.5", "set lmargin 10", "set border 31 lc rgb '#404040'", "unset key",
            "set tics nomirror",
            "set grid xtics ytics lt 1 lc rgb '#E8E8E8' lw 0.7", "set errorbars 0.4",
            "set xlabel 'GPU ms per simulated second' offset 0,0.4",
        };

        // Groups are not divided between rows; null leaves a cell empty. The last cell of the last row is the legend's.
        private List<List<ChartPanel>> Rows(int columns)
        {
            var rows = new List<List<ChartPanel>> { new List<ChartPanel>() };
            var waiting = new List<IReadOnlyList<ChartPanel>>(groups);
            while (waiting.Count > 0)
            {
                List<ChartPanel> row = rows[rows.Count - 1];
                IReadOnlyList<ChartPanel> next = waiting.FirstOrDefault(g => g.Count <= columns - row.Count);
                if (next != null)
                {
                    row.AddRange(next);
                    waiting.Remove(next);
                }
                else if (row.Count < columns)
                {
                    row.Add(null);
                }
                if (row.Count == columns) rows.Add(new List<ChartPanel>());
            }
            return rows;
        }

        private IEnumerable<string> Legend()
        {
            var entries = new List<string>();
            HashSet<string> methods = new HashSet<string>(groups.SelectMany(g => g).SelectMany(p => p.Points).Select(p => p.Method));
            for (int m = 0; m < CaseMethod.All.Count; m++)
            {
                if (methods.Contains(CaseMethod.All[m].Name))
                {
                    entries
                        .Add(
                            $"1/0 with linespoints lw 2 pt 7 ps 1.5 lc {ChartStyle.Colour(m)} title " +
                            $"{Gnuplot.Quote(CaseMethod.All[m].Title)}");
                }
            }
            HashSet<ChartFactor> factors = new HashSet<ChartFactor>(groups.SelectMany(g => g).SelectMany(p => p.Points.Select(p.FactorOf)));
            foreach ((ChartFactor factor, int symbol, string title) in ChartStyle.Factors.Where(f => factors.Contains(f.Factor)))
            {
                entries.Add($"1/0 with points pt {symbol} ps {ChartStyle.Size(factor)} lc rgb '#606060' title {Gnuplot.Quote(title)}");
            }
            entries.Add("1/0 with points pt 6 ps 1.5 lw 1.5 lc rgb '#606060' title 'open, at the top: a run failed'");
            entries.Add("1/0 with xyerrorbars pt 7 ps 0.6 lc rgb '#606060' title 'median, least and greatest of the seeds'");
            entries.Add("1/0 with lines lw 1.5 dt 2 lc rgb '#A0A0A0' title 'real time at 4 and 8 ms a frame of 60 Hz'");
            entries.Add("1/0 with boxes fs solid 1.0 noborder lc rgb '#E6E6E6' title 'below what the reference is good for'");
            yield return "unset border; unset tics; unset xlabel; unset ylabel; unset title; unset label; unset arrow; unset object; " +
                "unset grid; unset logscale";
            yield return "set key center center Left reverse spacing 1.5 samplen 2.5 width 1";
            yield return "plot [0:1][0:1] " + string.Join(", \\\n    ", entries);
        }
    }
}
