using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>The gnuplot script of a map, with its data: a panel a method, a cell the worst of its seeds, a letter its cause.</summary>
    public sealed class StabilityScript
    {
        const int PanelWidth = 760, PanelHeight = 560, LegendHeight = 150;

        // Blue, yellow and vermilion of M. Okabe and K. Ito, which colour-blind readers tell apart, paled for the letters on them.
        static readonly string[] colours = { "#9BC8E8", "#F5E37A", "#E79A6B" };
        static readonly string[] lines = { "lw 2.5 lc rgb 'black'", "lw 2.5 dt 2 lc rgb 'black'", "lw 2.5 dt 3 lc rgb 'black'" };

        readonly StabilityMap map;
        readonly IReadOnlyList<StabilityRow> rows;
        readonly bool clamps;
        readonly string device;

        /// <summary>A script.</summary>
        /// <param name="map">The map.</param>
        /// <param name="rows">Its runs, all with or all without clamps.</param>
        /// <param name="clamps">Whether the emergency limit on accelerations acted.</param>
        /// <param name="device">The graphics device.</param>
        public StabilityScript(StabilityMap map, IReadOnlyList<StabilityRow> rows, bool clamps, string device)
        {
            this.map = map;
            this.rows = rows;
            this.clamps = clamps;
            this.device = device;
        }

        /// <summary>Name of the script's file, for instance "stability-m1.gp", and "stability-m1-clamps.gp" with clamps.</summary>
        public string FileName => Stem + ".gp";

        internal static string StemOf(StabilityMap map, bool clamps) => $"stability-{map.Name.ToLowerInvariant()}{(clamps ? "-clamps" : "")}";

        internal static string FirstLineOf(string stem) => $"# Draws {stem}.svg and {stem}.png: gnuplot {stem}.gp";

        string Stem => StemOf(map, clamps);

        /// <summary>The script's lines.</summary>
        public IEnumerable<string> Lines()
        {
            List<CaseMethod> methods = CaseMethod.All.Where(m => rows.Any(r => r.Method == m.Name)).ToList();
            yield return FirstLineOf(Stem);
            foreach (CaseMethod method in methods)
            {
                foreach (string line in Cells(method))
                    yield return line;
            }
            for (int b = 0; b < map.Borders.Count; b++)
            {
                foreach (string line in Line(b))
                    yield return line;
            }
            string size = $"size {methods.Count * PanelWidth},{PanelHeight + LegendHeight}";
            yield return "do for [format in \"svg png\"] {";
            yield return "reset";
            yield return $"if (format eq \"svg\") {{ set terminal svg noenhanced {size} font 'DejaVu Sans,14' background 'white' }} " +
                $"else {{ set terminal pngcairo noenhanced {size} font 'DejaVu Sans,11' background 'white' }}";
            yield return $"set output '{Stem}.' . format";
            string date = rows.Max(r => r.Date);
            string title = $"{map.Name}: {map.Title}{(clamps ? ", accelerations limited" : "")}. {device}, {date}";
            yield return $"set multiplot layout 1,{methods.Count} title {Gnuplot.Quote(title)} font ',13'";
            foreach (string line in Frame())
                yield return line;
            for (int m = 0; m < methods.Count; m++)
            {
                yield return $"set title {Gnuplot.Quote(methods[m].Title)}";
                yield return "plot " + string.Join(", \\\n    ", Layers(methods[m]));
            }
            yield return "unset multiplot";
            yield return "unset output";
            yield return "}";
        }

        IEnumerable<string> Line(int index)
        {
            StabilityBorder border = map.Borders[index];
            yield return $"$border{index} << END";
            for (int i = 0; i <= 60; i++)
            {
                double place = i / 60.0 * 1.2 - 0.1;
                double y = border.X == null ? border.Level : At(map.Y, place);
                yield return Gnuplot.Number(border.X == null ? At(map.X, place) : border.X(y)) + " " + Gnuplot.Number(y);
            }
            yield return "END";
        }

        IEnumerable<string> Frame()
        {
            foreach ((string name, StabilityAxis axis, int count) in new[] { ("x", map.X, Columns(r => r.X)), ("y", map.Y, Columns(r => r.Y)) })
            {
                double half = 0.5 / Math.Max(1, count - 1);
                if (axis.IsLogarithmic)
                    yield return $"set logscale {name}";
                yield return $"set {name}range [{Gnuplot.Number(At(axis, -half))}:{Gnuplot.Number(At(axis, 1.0 + half))}]";
                yield return $"set {name}label {Gnuplot.Quote(axis.Title)}";
                yield return axis.IsLogarithmic ? $"set {name}tics ({Tics(axis)})" : $"set {name}tics format '%g'";
            }
            yield return "set border 31 lc rgb '#404040'; set tics nomirror out; set bmargin 11; set tmargin 4; set lmargin 9; set rmargin 3";
            yield return "set key at graph 0.5, graph -0.19 center top horizontal Left reverse samplen 2 spacing 1.15 maxcols 2 width 2 font ',10'";
            string letters = string.Join("   ", StabilityCauses.All.Where(c => rows.Any(r => r.Outcome.Cause == c)).Select(c => $"{StabilityCauses.Letter(c)} {StabilityCauses.Title(c)}"));
            if (rows.Any(r => r.Outcome.IsCut))
                letters += "   * ended by its budget";
            yield return $"set label 1 {Gnuplot.Quote(letters.Trim())} at graph 0.5, graph -0.16 center font ',10'";
        }

        IEnumerable<string> Layers(CaseMethod method)
        {
            string data = DataName(method);
            for (int v = 0; v < colours.Length; v++)
            {
                yield return $"{data} using ($7 == {v} ? $1 : NaN):2:3:4:5:6 with boxxyerror fs solid 1.0 border lc rgb 'white' fc rgb '{colours[v]}' " +
                    $"title '{((StabilityVerdict)v).ToString().ToLowerInvariant()}'";
            }
            yield return $"{data} using 1:2:8 with labels font ',12' tc rgb '#303030' notitle";
            int style = 0;
            foreach (int b in Enumerable.Range(0, map.Borders.Count).Where(i => map.Borders[i].Theory == StabilityTheory.Of(method)))
                yield return $"$border{b} using 1:2 with lines {lines[style++ % lines.Length]} title {Gnuplot.Quote(map.Borders[b].Title)}";
        }

        IEnumerable<string> Cells(CaseMethod method)
        {
            double halfX = 0.5 / Math.Max(1, Columns(r => r.X) - 1), halfY = 0.5 / Math.Max(1, Columns(r => r.Y) - 1);
            yield return $"{DataName(method)} << END";
            foreach (IGrouping<(string, string), StabilityRow> cell in rows.Where(r => r.Method == method.Name).GroupBy(r => (CsvText.Text(r.X), CsvText.Text(r.Y))))
            {
                StabilityRow worst = cell.OrderByDescending(r => r.Outcome.Verdict).ThenBy(r => r.Seed).First();
                double x = map.X.Place(worst.X), y = map.Y.Place(worst.Y);
                string letter = StabilityCauses.Letter(worst.Outcome.Cause) + (cell.Any(r => r.Outcome.IsCut) ? "*" : "");
                yield return string.Join(" ", new[] { worst.X, worst.Y, At(map.X, x - halfX), At(map.X, x + halfX), At(map.Y, y - halfY), At(map.Y, y + halfY) }
                    .Select(Gnuplot.Number)) + $" {(int)worst.Outcome.Verdict} \"{letter}\"";
            }
            yield return "END";
        }

        int Columns(Func<StabilityRow, double> value) => rows.Select(r => CsvText.Text(value(r))).Distinct().Count();

        static string DataName(CaseMethod method) => "$" + method.Name.Replace('-', '_');

        static double At(StabilityAxis axis, double place) =>
            axis.IsLogarithmic ? axis.Low * Math.Pow(axis.High / axis.Low, place) : axis.Low + (axis.High - axis.Low) * place;

        static string Tics(StabilityAxis axis)
        {
            var tics = new List<string>();
            for (int exponent = -4; exponent <= 3; exponent++)
            {
                foreach (int digit in new[] { 1, 2, 3, 5 })
                {
                    double value = double.Parse($"{digit}e{exponent}", CultureInfo.InvariantCulture);
                    if (value >= axis.Low * 0.9 && value <= axis.High * 1.1)
                        tics.Add($"'{value.ToString("0.####", CultureInfo.InvariantCulture)}' {Gnuplot.Number(value)}");
                }
            }
            return string.Join(", ", tics);
        }
    }
}
