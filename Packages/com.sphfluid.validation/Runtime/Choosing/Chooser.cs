using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>Answers which method, which κ and which spacing a liquid needs, from a chart that was measured on the device.</summary>
    public sealed class Chooser
    {
        private readonly ChartData chart;
        private readonly IReadOnlyList<ErrorModel> models;

        /// <summary>Fits a chart.</summary>
        /// <param name="chart">The chart.</param>
        public Chooser(ChartData chart) : this(chart, CaseCatalogue.All.Where(c => !c.IsGate))
        {
        }

        internal Chooser(ChartData chart, IEnumerable<ValidationCase> cases)
        {
            this.chart = chart;
            models = ErrorModel.Of(chart, cases);
        }

        /// <summary>The cases that it can answer for.</summary>
        public IEnumerable<ValidationCase> Cases => models.Select(m => m.Case);

        /// <summary>Answers a question.</summary>
        /// <param name="question">What is asked.</param>
        /// <exception cref="CommandLineException">Neither an error nor a time is asked for, the error is below what the reference is good
        /// for, or the chart has no curve of the case.</exception>
        public ChoiceAnswer Answer(ChoiceQuestion question)
        {
            if (double.IsNaN(question.Error) && double.IsNaN(question.Milliseconds))
            {
                throw new CommandLineException(
                    "Give what the liquid may err with --error, what it may cost with --ms, or both: --error 5% --ms 4.");
            }
            if (question.Error < question.Case.Floor)
            {
                throw new CommandLineException(string.Format(CultureInfo.InvariantCulture,
                    "--error: the reference of {0} itself is good for {1:0.##} % ({2}), and nothing below " +
                    "can be told apart. Ask for as much or more.", question.Case.Name, 100.0 * question.Case.Floor,
                    question.Case.FloorSource));
            }
            ErrorModel model = models.FirstOrDefault(m => m.Case == question.Case) ?? throw new CommandLineException(
                $"The chart in '{chart.Folder}' has no whole run of {question.Case.Name}. Measure it: ./run chart --case " +
                $"{question.Case.Name}.");
            List<ChoiceOption> options = Options(model, question).ToList();
            if (options.Count == 0)
            {
                throw new CommandLineException(string.Format(CultureInfo.InvariantCulture,
                    "--compression: the chart in '{0}' has no run of {1} with {2:G3} % or less; its stiffest " +
                    "has {3:G2} %.", chart.Folder, question.Case.Name, 100.0 * question.Compression, 100.0 * Stiffest(model)));
            }
            return new ChoiceAnswer(question, chart, options);
        }

        /// <summary>What is expected of a point, however it compares; null where the chart does not cover it.</summary>
        internal ChoiceOption Expect(ChoiceQuestion question, string method, double supportRatio, double soundSpeedRatio, int resolution)
        {
            ChoiceCurve curve = models.FirstOrDefault(m => m.Case == question.Case)?.Curves.FirstOrDefault(c => c.First.Method == method &&
                c.First.SupportRatio.Equals(supportRatio) && c.First.SoundSpeedRatio.Equals(soundSpeedRatio));
            return curve != null && curve.Error.Covers(resolution) ? new ChoiceOption(curve, resolution, ChoiceScale.Of(question)) : null;
        }

        private static double Stiffest(ErrorModel model) => model.Curves.Min(c => c.Compression);

        // The text as printed is not for use.
        private static IEnumerable<ChoiceOption> Options(ErrorModel model, ChoiceQuestion question)
        {
            ChoiceScale scale = ChoiceScale.Of(question);
            foreach (ChoiceCurve curve in model.Curves.Where(c => !CaseMethod.Find(c.First.Method).IsReference))
            {
                if (curve.Compression > question.Compression * 1.001) continue;
                int last = curve.Points[curve.Points.Count - 1].Resolution;
                for (int resolution = curve.Points[0].Resolution; resolution <= last; resolution++)
                {
                    if (curve.Error.Covers(resolution)) yield return new ChoiceOption(curve, resolution, scale);
                }
            }
        }
    }
}
