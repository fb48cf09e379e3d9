using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// The gnuplot script of a case's picture, with its data: the curves of its base against the reference. Three references or more,
    /// with as many curves of each method, have a panel each; else all curves share one.
    /// </summary>
    public sealed class CurveScript : GnuplotScript
    {
        private const int FewestPointsAsMarks = 5, MostPointsAsMarks = 40;
        private const int FewestPanels = 3;
        private const int HeadingLineHeight = 20; // px
        private const string Page = "noenhanced font 'DejaVu Sans,11' background 'white'";

        private readonly ValidationCase validationCase;
        private readonly IReadOnlyList<CaseCurves.Run> runs;
        private readonly IReadOnlyList<CaseSeries> references, bands; // a band behind each reference, or null

        /// <summary>The picture of the curves that a folder has.</summary>
        /// <param name="validationCase">The case.</param>
        /// <param name="folder">The chart's folder.</param>
        public CurveScript(ValidationCase validationCase, string folder) : base(StemOf(validationCase), "png")
        {
            this.validationCase = validationCase;
            var curves = new CaseCurves(validationCase, folder);
            references = curves.References;
            bands = references.Select(curves.BandOf).ToList();
            runs = curves.Runs;
        }

        /// <summary>Script and picture of a case.</summary>
        internal static IEnumerable<ResultFile> Files(ValidationCase validationCase) => Files(StemOf(validationCase), "png");

        /// <summary>Whether there is nothing to draw.</summary>
        public bool IsEmpty => runs.Count == 0;

        private protected override IEnumerable<string> Body()
        {
            var lines = new List<string>();
            for (int i = 0; i < references.Count; i++)
            {
                lines.AddRange(Block(ReferenceName(i), Points(references[i])));
                if (bands[i] != null) lines.AddRange(Block(BandName(i), Band(bands[i])));
            }
            foreach (CaseCurves.Run run in runs)
            {
                for (int i = 0; i < run.Curves.Count; i++) lines.AddRange(Block(CurveName(run.Method, i), Points(run.Curves[i])));
            }
            (string x, string y) = validationCase.AxisTitles;
            var axes = new List<string>
            {
                "set autoscale xfix", $"set xlabel {Gnuplot.Quote(x)}", $"set ylabel {Gnuplot.Quote(y)}",
                "set grid lt 1 lc rgb '#E8E8E8' lw 0.7", "set border 31 lc rgb '#404040'",
            };
            axes.AddRange(Range());
            bool divided = references.Count >= FewestPanels && runs.All(r => r.Curves.Count == references.Count);
            lines.AddRange(divided ? Divided(axes) : Single(axes));
            return lines;
        }

        private IEnumerable<string> Single(List<string> axes)
        {
            List<string> layers = Enumerable.Range(0, references.Count).SelectMany(Experiments)
                .Concat(Enumerable.Range(0, references.Count).Select(i => Reference(i, references[i].Name))).ToList();
            foreach (CaseCurves.Run run in runs)
            {
                layers
                    .AddRange(
                        run.Curves.Select((curve, i) => Curve(run.Method, i, i, $"{CaseMethod.All[run.Method].Title}: {curve.Name}")));
            }
            yield return $"set terminal pngcairo size 900,{480 + HeadingHeight + 22 * ((layers.Count + 1) / 2)} {Page}";
            yield return Output;
            foreach (string line in axes) yield return line;
            yield return $"set title {Heading} font ',12'";
            yield return "set key outside below Left reverse maxcols 2";
            yield return "set bmargin " + (5 + (layers.Count + 1) / 2);
            yield return Plot(layers);
        }

        private IEnumerable<string> Divided(List<string> axes)
        {
            int rows = (references.Count + 1) / 2;
            int height = 70 + HeadingHeight + 360 * rows;
            yield return $"set terminal pngcairo size 1100,{height} {Page}";
            yield return Output;
            yield return $"set multiplot layout {rows},2 title {Heading}.\"\\n \\n \" font ',12'";
            foreach (string line in axes) yield return line;
            for (int i = 0; i < references.Count; i++)
            {
                // Above the panels, once for all.
                yield return i == 0
                    ? $"set key at screen 0.5, screen {Gnuplot.Number(1.0 - (26.0 + HeadingHeight) / height)} center horizontal maxrows 1"
                    : "unset key";
                yield return $"set title {Gnuplot.Quote(references[i].Name)} font ',11'";
                yield return Plot(Experiments(i).Append(Reference(i, "reference", 0))
                    .Concat(runs.Select(r => Curve(r.Method, i, 0, CaseMethod.All[r.Method].Title))));
            }
            yield return "unset multiplot";
        }

        private string Output => $"set output '{StemOf(validationCase)}.png'";

        private static string StemOf(ValidationCase validationCase) => $"case-{validationCase.Name}";

        private string Heading => string.Join(".\"\\n\".", HeadingLines.Select(Gnuplot.Quote));

        private int HeadingHeight => HeadingLineHeight * HeadingLines.Count;

        // The constants below the title; each method's on a line of its own where they differ.
        private IReadOnlyList<string> HeadingLines
        {
            get
            {
                bool same = runs.All(r => r.Constants == runs[0].Constants);
                IEnumerable<string> constants = same ? new[] { runs[0].Constants }
                    : runs.Select(r => $"{CaseMethod.All[r.Method].Title}: {r.Constants}");
                return constants.Prepend(validationCase.Title).ToList();
            }
        }

        private string Reference(int index, string title, int style = -1)
        {
            int look = style < 0 ? index : style;
            int points = references[index].X.Count;
            string drawn = points >= FewestPointsAsMarks && points <= MostPointsAsMarks ? $"points pt {Mark(look)} ps 1.1 lw 1.5"
                : $"lines lw 2 dt {look + 1}";
            return $"{ReferenceName(index)} using 1:2 with {drawn} lc rgb 'black' title {Gnuplot.Quote(title)}";
        }

        // One experiment is a band without width: its edges are drawn.
        private IEnumerable<string> Experiments(int index)
        {
            if (bands[index] == null) yield break;
            yield return $"{BandName(index)} using 1:2:3 with filledcurves fc rgb '#DADADA' notitle";
            yield return $"{BandName(index)} using 1:2 with lines lw 1.5 lc rgb '#A8A8A8' title 'experiments'";
            yield return $"{BandName(index)} using 1:3 with lines lw 1.5 lc rgb '#A8A8A8' notitle";
        }

        private static string Curve(int method, int index, int style, string title) =>
            $"{CurveName(method, index)} using 1:2 with lines lw 2 dt {style + 1} lc {ChartStyle.Colour(method)} title " +
            $"{Gnuplot.Quote(title)}";

        // A run that flies apart leaves the picture: the reference stays readable.
        private IEnumerable<string> Range()
        {
            List<double> expected = references.SelectMany(r => r.Y).Concat(bands.Where(b => b != null).SelectMany(b => b.Upper))
                .Where(IsFinite).ToList();
            if (expected.Count == 0) yield break;
            List<double> all = runs.SelectMany(r => r.Curves).SelectMany(c => c.Y).Where(IsFinite).Concat(expected).ToList();
            double span = expected.Max() - expected.Min();
            double low = Math.Max(all.Min(), expected.Min() - span), high = Math.Min(all.Max(), expected.Max() + span);
            double margin = 0.05 * (high - low);
            if (margin > 0.0) yield return $"set yrange [{Gnuplot.Number(low - margin)}:{Gnuplot.Number(high + margin)}]";
        }

        private static bool IsFinite(double value) => !double.IsNaN(value) && !double.IsInfinity(value);

        private static IEnumerable<string> Points(CaseSeries curve) =>
            Enumerable.Range(0, curve.X.Count).Select(i => $"{Gnuplot.Number(curve.X[i])} {Gnuplot.Number(curve.Y[i])}");

        private static IEnumerable<string> Band(CaseSeries band) => Points(band).Select((p, i) => $"{p} {Gnuplot.Number(band.Upper[i])}");

        private static string BandName(int index) => $"$band{index}";

        private static string ReferenceName(int index) => $"$reference{index}";

        private static string CurveName(int method, int index) => $"$method{method}_{index}";

        // Open circle, square, triangle, ...
        private static int Mark(int index) => new[] { 6, 4, 8, 10, 12 }[index % 5];
    }
}
