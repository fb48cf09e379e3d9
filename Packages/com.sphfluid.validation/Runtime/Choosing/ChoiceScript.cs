using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// The picture of an answer: the case's measured points, the fitted curves, what was asked and where the answer lies.
    /// </summary>
    internal sealed class ChoiceScript : GnuplotScript
    {
        private const string Stem = "choose";

        private readonly ChoiceAnswer answer;
        private readonly List<IGrouping<string, ChoiceOption>> methods;

        public ChoiceScript(ChoiceAnswer answer) : base(Stem, "svg", "png")
        {
            this.answer = answer;
            methods = answer.Options.GroupBy(o => o.Method).ToList();
        }

        /// <summary>Script and pictures.</summary>
        internal static IEnumerable<ResultFile> Files() => Files(Stem, "svg", "png");

        private protected override IEnumerable<string> Body()
        {
            IEnumerable<string> data = methods.SelectMany((m, i) => Block($"$curves{i}", Curves(m))
                .Concat(Block($"$measured{i}", m.Where(IsMeasured).Where(answer.Holds).Select(Measured)))
                .Concat(Block($"$beyond{i}", m.Where(IsMeasured).Where(o => !answer.Holds(o)).Select(Measured))));
            if (Marked.Any()) data = data.Concat(Block("$answer", Marked.Select(Bars)));
            return data.Concat(InSvgAndPng("900,620", 14, 11, Drawing()));
        }

        private IEnumerable<ChoiceOption> Marked => answer.Best != null ? new[] { answer.Best }
            : new[] { double.IsNaN(answer.Question.Error) ? null : answer.Fastest ?? answer.Finest,
                double.IsNaN(answer.Question.Milliseconds) ? null : answer.MostAccurate ?? answer.QuickestOfAll }
                .Where(o => o != null).Distinct();

        private IEnumerable<string> Drawing()
        {
            ChoiceQuestion question = answer.Question;
            ChartAxis x = ChartAxis.Of(answer.Options.Select(o => o.Milliseconds.Value).Append(question.Milliseconds)
                .Concat(Marked.SelectMany(o => new[] { o.Milliseconds.Low, o.Milliseconds.High })));
            ChartAxis y = ChartAxis.Of(answer.Options.Select(o => o.Error.Value)
                .Concat(answer.Options.Where(IsMeasured).Select(MeasuredError)).Append(question.Error)
                .Concat(Marked.Select(o => o.Error.High)));
            yield return "set logscale xy; set border 31 lc rgb '#404040'; set tics nomirror; set grid lt 1 lc rgb '#E8E8E8' lw 0.7; set " +
                "key outside below Left reverse maxcols 2";
            yield return "set rmargin 4";
            yield return x.Script("x", v => Gnuplot.Number(v));
            yield return y.Script("y", ChoiceText.IsFraction(question.Case) ? ChartAxis.Percent
                : (System.Func<double, string>)(v => Gnuplot.Number(v)));
            yield return $"set xlabel {Gnuplot.Quote($"GPU ms a frame of 1/{Gnuplot.Number(question.FramesPerSecond)} s")}; set ylabel " +
                $"{Gnuplot.Quote(question.Case.ErrorName)}";
            string choice = answer.Best != null ? answer.Best.ToString() : "nothing that was measured has what was asked for";
            yield return $"set title {Gnuplot.Quote(question.Case.Title + ": " + choice)}" +
                $".\"\\n\".{Gnuplot.Quote($"{answer.Chart.Device}, {answer.Chart.Date}")} font ',12'";
            if (question.Error > 0.0)
            {
                yield return $"set arrow 1 from graph 0, first {Gnuplot.Number(question.Error)} to graph 1, first " +
                    $"{Gnuplot.Number(question.Error)} nohead dt 2 lw 1.5 lc rgb '#707070' back";
            }
            if (question.Milliseconds > 0.0)
            {
                yield return $"set arrow 2 from {Gnuplot.Number(question.Milliseconds)}, graph 0 to " +
                    $"{Gnuplot.Number(question.Milliseconds)}, graph 1 nohead dt 2 lw 1.5 lc rgb '#707070' back";
            }
            var layers = new List<string>();
            for (int i = 0; i < methods.Count; i++)
            {
                CaseMethod method = CaseMethod.Find(methods[i].Key);
                string colour = ChartStyle.Colour(CaseMethod.All.ToList().IndexOf(method));
                layers.Add($"$curves{i} using 1:2 with lines lw 1.5 lc {colour} title {Gnuplot.Quote(method.Title + ", expected")}");
                bool[] held = methods[i].Where(IsMeasured).Select(answer.Holds).ToArray();
                string within = method.Title + ", measured spacings", beyond = method.Title + ", beyond in another error";
                if (held.Contains(true)) layers.Add(Marks($"$measured{i}", "pt 7", colour, within));
                if (held.Contains(false)) layers.Add(Marks($"$beyond{i}", "pt 6 lw 1.5", colour, beyond));
            }
            if (Marked.Any())
            {
                layers.Add("$answer using 1:2:3:4:5:6 with xyerrorbars pt 3 ps 2.4 lw 2 lc rgb 'black' title " +
                    Gnuplot.Quote(answer.Best != null ? "the answer, and where 19 of 20 runs are expected"
                        : "the nearest in both directions"));
            }
            yield return Plot(layers);
        }

        private static string Marks(string data, string look, string colour, string title) =>
            $"{data} using 1:2 with points {look} ps 0.9 lc {colour} title {Gnuplot.Quote(title)}";

        // A line for each κ and speed of sound, with a gap between.
        private static IEnumerable<string> Curves(IEnumerable<ChoiceOption> options)
        {
            foreach (IGrouping<ChoiceCurve, ChoiceOption> curve in options.GroupBy(o => o.Curve))
            {
                foreach (ChoiceOption option in curve.OrderBy(o => o.Resolution)) yield return Point(option);
                yield return "";
            }
        }

        private static string Point(ChoiceOption option) => Gnuplot.Number(option.Milliseconds.Value) + " " +
            Gnuplot.Number(option.Error.Value);

        private static string Measured(ChoiceOption option) => Gnuplot.Number(option.Milliseconds.Value) + " " +
            Gnuplot.Number(MeasuredError(option));

        private static bool IsMeasured(ChoiceOption option) => option.Curve.Points.Any(p => p.Resolution == option.Resolution);

        private static double MeasuredError(ChoiceOption option) => System.Math.Exp(option.Curve.Error.Measured.At(option.Resolution));

        private static string Bars(ChoiceOption o) =>
            string.Join(" ", new[] { o.Milliseconds.Value, o.Error.Value, o.Milliseconds.Low, o.Milliseconds.High,
            System.Math.Max(1e-7, o.Error.Low), o.Error.High }.Select(Gnuplot.Number));
    }
}
