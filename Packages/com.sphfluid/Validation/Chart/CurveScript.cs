using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>The gnuplot script of a case's picture, with its data: the curves of its base against the reference.</summary>
    public sealed class CurveScript
    {
        const int MostPointsAsMarks = 40;
        const int LegendLine = 22;

        readonly ValidationCase validationCase;
        readonly List<(int Method, string Run, IReadOnlyList<CaseSeries> Curves)> runs = new List<(int, string, IReadOnlyList<CaseSeries>)>();

        /// <summary>The picture of the curves that a folder has.</summary>
        /// <param name="validationCase">The case.</param>
        /// <param name="folder">The chart's folder.</param>
        public CurveScript(ValidationCase validationCase, string folder)
        {
            this.validationCase = validationCase;
            for (int m = 0; m < CaseMethod.All.Count; m++)
            {
                IReadOnlyList<CaseSeries> curves = CurveFile.Read(CurveFile.PathOf(folder, validationCase.Name, CaseMethod.All[m].Name), out string run);
                if (curves.Count > 0)
                    runs.Add((m, run, curves));
            }
        }

        /// <summary>Name of the script's file.</summary>
        public string FileName => $"case-{validationCase.Name}.gp";

        /// <summary>Whether there is nothing to draw.</summary>
        public bool IsEmpty => runs.Count == 0;

        /// <summary>The script's lines.</summary>
        public IEnumerable<string> Lines()
        {
            var layers = new List<string>();
            yield return $"# Draws case-{validationCase.Name}.png: gnuplot {FileName}";
            // The references of all methods are the same.
            List<CaseSeries> references = runs.SelectMany(r => r.Curves).Where(c => c.IsReference).GroupBy(c => c.Name).Select(g => g.First()).ToList();
            for (int i = 0; i < references.Count; i++)
            {
                foreach (string line in Block($"$reference{i}", references[i]))
                    yield return line;
                string style = references[i].X.Count <= MostPointsAsMarks ? $"points pt {Mark(i)} ps 1.1 lw 1.5" : $"lines lw 2 dt {i + 1}";
                layers.Add($"$reference{i} using 1:2 with {style} lc rgb 'black' title {Gnuplot.Quote(references[i].Name)}");
            }
            bool sameConstants = runs.All(r => r.Run == runs[0].Run);
            foreach ((int method, string run, IReadOnlyList<CaseSeries> curves) in runs)
            {
                string constants = sameConstants ? "" : $" ({run})";
                List<CaseSeries> measured = curves.Where(c => !c.IsReference).ToList();
                for (int i = 0; i < measured.Count; i++)
                {
                    string name = $"$method{method}_{i}";
                    foreach (string line in Block(name, measured[i]))
                        yield return line;
                    layers.Add($"{name} using 1:2 with lines lw 2 dt {i + 1} lc {ChartStyle.Colour(method)} " +
                        $"title {Gnuplot.Quote($"{CaseMethod.All[method].Title}: {measured[i].Name}{constants}")}");
                }
            }
            (string x, string y) = validationCase.AxisTitles;
            int height = 500 + LegendLine * ((layers.Count + 1) / 2);
            yield return $"set terminal pngcairo noenhanced size 900,{height} font 'DejaVu Sans,11' background 'white'";
            yield return $"set output 'case-{validationCase.Name}.png'";
            yield return $"set title {Gnuplot.Quote(validationCase.Title)} font ',13'";
            yield return $"set xlabel {Gnuplot.Quote(x)}";
            yield return $"set ylabel {Gnuplot.Quote(y)}";
            yield return "set grid lt 1 lc rgb '#E8E8E8' lw 0.7";
            yield return "set border lc rgb '#404040'";
            yield return "set key outside below Left reverse maxcols 2";
            if (sameConstants)
                yield return $"set label {Gnuplot.Quote(runs[0].Run)} at graph 0.99, graph 0.04 right font ',9' tc rgb '#707070'";
            foreach (string line in Range(references))
                yield return line;
            yield return "plot " + string.Join(", \\\n    ", layers);
        }

        // A run that flies apart leaves the picture: the reference stays readable.
        IEnumerable<string> Range(List<CaseSeries> references)
        {
            List<double> expected = references.SelectMany(r => r.Y).Where(IsFinite).ToList();
            if (expected.Count == 0)
                yield break;
            List<double> all = runs.SelectMany(r => r.Curves).SelectMany(c => c.Y).Where(IsFinite).ToList();
            double span = expected.Max() - expected.Min();
            double low = Math.Max(all.Min(), expected.Min() - span), high = Math.Min(all.Max(), expected.Max() + span);
            double margin = 0.05 * (high - low);
            if (margin > 0.0)
                yield return $"set yrange [{Gnuplot.Number(low - margin)}:{Gnuplot.Number(high + margin)}]";
        }

        static bool IsFinite(double value) => !double.IsNaN(value) && !double.IsInfinity(value);

        static IEnumerable<string> Block(string name, CaseSeries curve)
        {
            yield return $"{name} << END";
            for (int i = 0; i < curve.X.Count; i++)
                yield return $"{Gnuplot.Number(curve.X[i])} {Gnuplot.Number(curve.Y[i])}";
            yield return "END";
        }

        // Open circle, square, triangle, ...
        static int Mark(int index) => new[] { 6, 4, 8, 10, 12 }[index % 5];
    }
}
