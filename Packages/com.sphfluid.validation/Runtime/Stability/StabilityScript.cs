using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>The gnuplot script of a map, with its data: a panel a method, a cell the worst of its seeds, a letter its cause.</summary>
    public sealed class StabilityScript : GnuplotScript
    {
        private const int PanelWidth = 760, PanelHeight = 560, LegendHeight = 150;

        // Blue, yellow and vermilion of M. Okabe and K. Ito, which colour-blind readers can distinguish, paled for the letters on them.
        private static readonly string[] colours = { "#9BC8E8", "#F5E37A", "#E79A6B" };
        private static readonly string[] formats = { "svg", "png" };
        private static readonly string[] lines = { "lw 2.5 lc rgb 'black'", "lw 2.5 dt 2 lc rgb 'black'", "lw 2.5 dt 3 lc rgb 'black'" };

        private readonly StabilityMap map;
        private readonly IReadOnlyList<StabilityRow> rows;
        private readonly bool clamps;

        /// <summary>A script.</summary>
        /// <param name="map">The map.</param>
        /// <param name="rows">Its runs, all with or all without clamps.</param>
        /// <param name="clamps">Whether the emergency limit on accelerations acted.</param>
        public StabilityScript(StabilityMap map, IReadOnlyList<StabilityRow> rows, bool clamps) : base(StemOf(map, clamps), formats)
        {
            this.map = map;
            this.rows = rows;
            this.clamps = clamps;
        }

        /// <summary>Scripts and pictures of a map, without and with clamps: stability-m1.gp, stability-m1-clamps.gp and so on.</summary>
        internal static IEnumerable<ResultFile> Files(StabilityMap map) =>
            Files(StemOf(map, false), formats).Concat(Files(StemOf(map, true), formats));

        private protected override IEnumerable<string> Body()
        {
            List<CaseMethod> methods = CaseMethod.All.Where(m => rows.Any(r => r.Method == m.Name)).ToList();
            return methods.SelectMany(m => Block(DataName(m), Cells(m)))
                .Concat(map.Lines.SelectMany((line, index) => Block("$border" + index, Points(line))))
                .Concat(InSvgAndPng($"{methods.Count * PanelWidth},{PanelHeight + LegendHeight}", 14, 11, Drawing(methods)));
        }

        private IEnumerable<string> Drawing(List<CaseMethod> methods)
        {
            string title = $"{map.Name}: {map.Title}{(clamps ? ", accelerations limited" : "")}. {rows[0].Device}, {rows.Max(r => r.Date)}";
            yield return $"set multiplot layout 1,{methods.Count} title {Gnuplot.Quote(title)} font ',13'";
            foreach (string line in Frame()) yield return line;
            foreach (CaseMethod method in methods)
            {
                yield return $"set title {Gnuplot.Quote(method.Title)}";
                yield return Plot(Layers(method));
            }
            yield return "unset multiplot";
        }

        private IEnumerable<string> Points(TheoryLine line)
        {
            for (int i = 0; i <= 60; i++)
            {
                double place = i / 60.0 * 1.2 - 0.1;
                double y = line.X == null ? line.Level : map.Y.At(place);
                yield return Gnuplot.Number(line.X == null ? map.X.At(place) : line.X(y)) + " " + Gnuplot.Number(y);
            }
        }

        private IEnumerable<string> Frame()
        {
            foreach ((string name, StabilityAxis axis, int count) in new[] { ("x", map.X, Columns(r => r.X)),
                ("y", map.Y, Columns(r => r.Y)) })
            {
                double half = 0.5 / Math.Max(1, count - 1);
                if (axis.IsLogarithmic) yield return $"set logscale {name}";
                yield return $"set {name}range [{Gnuplot.Number(axis.At(-half))}:{Gnuplot.Number(axis.At(1.0 + half))}]";
                yield return $"set {name}label {Gnuplot.Quote(axis.Title)}";
                yield return axis.IsLogarithmic ? $"set {name}tics ({Tics(axis)})" : $"set {name}tics format '%g'";
            }
            yield return "set border 31 lc rgb '#404040'; set tics nomirror out; set bmargin 11; set tmargin 4; set lmargin 9; set " +
                "rmargin 3";
            yield return "set key at graph 0.5, graph -0.19 center top horizontal Left reverse samplen 2 spacing 1.15 maxcols 2 width 2 " +
                "font ',10'";
            string letters = string.Join("   ",
                StabilityLegend.Causes.Where(c => rows.Any(r => r.Outcome.Cause == c))
                    .Select(c => $"{StabilityLegend.Letter(c)} {StabilityLegend.Title(c)}"));
            if (rows.Any(r => r.Outcome.IsCut)) letters += "   * ended by its budget";
            yield return $"set label 1 {Gnuplot.Quote(letters.Trim())} at graph 0.5, graph -0.16 center font ',10'";
        }

        private IEnumerable<string> Layers(CaseMethod method)
        {
            string data = DataName(method);
            for (int v = 0; v < colours.Length; v++)
            {
                yield return $"{data} using ($7 == {v} ? $1 : NaN):2:3:4:5:6 with boxxyerror fs solid 1.0 border lc rgb 'white' fc rgb " +
                    $"'{colours[v]}' " +
                    $"title '{((StabilityVerdict)v).ToString().ToLowerInvariant()}'";
            }
            yield return $"{data} using 1:2:8 with labels font ',12' tc rgb '#303030' notitle";
            int style = 0;
            foreach (int b in Enumerable.Range(0, map.Lines.Count).Where(i => map.Lines[i].Theory == StabilityTheory.Of(method)))
            {
                yield return $"$border{b} using 1:2 with lines {lines[style++ % lines.Length]} title {Gnuplot.Quote(map.Lines[b].Title)}";
            }
        }

        private IEnumerable<string> Cells(CaseMethod method)
        {
            double halfX = 0.5 / Math.Max(1, Columns(r => r.X) - 1), halfY = 0.5 / Math.Max(1, Columns(r => r.Y) - 1);
            foreach (IGrouping<(string, string), StabilityRow> cell in rows.Where(r => r.Method == method.Name)
                .GroupBy(r => (CsvText.Text(r.X), CsvText.Text(r.Y))))
            {
                StabilityRow worst = cell.OrderByDescending(r => r.Outcome.Verdict).ThenBy(r => r.Seed).First();
                double x = map.X.Place(worst.X), y = map.Y.Place(worst.Y);
                string letter = StabilityLegend.Letter(worst.Outcome.Cause) + (cell.Any(r => r.Outcome.IsCut) ? "*" : "");
                yield return string.Join(" ",
                    new[] { worst.X, worst.Y, map.X.At(x - halfX), map.X.At(x + halfX), map.Y.At(y - halfY), map.Y.At(y + halfY) }
                    .Select(Gnuplot.Number)) + $" {(int)worst.Outcome.Verdict} \"{letter}\"";
            }
        }

        private int Columns(Func<StabilityRow, double> value) => rows.Select(r => CsvText.Text(value(r))).Distinct().Count();

        private static string StemOf(StabilityMap map, bool clamps) =>
            $"stability-{map.Name.ToLowerInvariant()}{(clamps ? "-clamps" : "")}";

        private static string DataName(CaseMethod method) => "$" + method.Name.Replace('-', '_');

        private static string Tics(StabilityAxis axis)
        {
            var tics = new List<string>();
            for (int exponent = -4; exponent <= 3; exponent++)
            {
                foreach (int digit in new[] { 1, 2, 3, 5 })
                {
                    double value = double.Parse($"{digit}e{exponent}", CultureInfo.InvariantCulture);
                    if (value >= axis.Low * 0.9 && value <= axis.High * 1.1)
                    {
                        tics.Add($"'{value.ToString("0.####", CultureInfo.InvariantCulture)}' {Gnuplot.Number(value)}");
                    }
                }
            }
            return string.Join(", ", tics);
        }
    }
}
