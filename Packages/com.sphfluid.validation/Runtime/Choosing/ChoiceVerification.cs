using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// Asks questions whose answers the chart has, runs each answer with a seed that the chart did not have, and compares.
    /// </summary>
    internal sealed class ChoiceVerification
    {
        private const int FirstSeed = 101;
        private const double PaceRatio = 2.25;
        private const int PaceParticles = 4000;

        // A run of a minute of llvmpipe on two cores, or as much of a graphics card.
        private const double LongestSeconds = 60.0;

        // Parts of the way from the least to the largest error or time that a case has.
        private static readonly double[] shares = { 0.25, 0.5, 0.1, 0.7, 0.35, 0.6, 0.2 };

        private readonly ChartData chart;
        private readonly Chooser chooser;
        private readonly FluidShaderSet shaders;
        private readonly ChooseArguments arguments;
        private readonly SessionProgress progress;

        public ChoiceVerification(ChartData chart, Chooser chooser, FluidShaderSet shaders, ChooseArguments arguments,
            SessionProgress progress)
        {
            this.chart = chart;
            this.chooser = chooser;
            this.shaders = shaders;
            this.arguments = arguments;
            this.progress = progress;
        }

        public IEnumerator Run()
        {
            var table = new ResultTable<VerificationRow>(VerificationRow.Format, arguments.OutputFolder, chart.Device);
            List<ChoiceQuestion> questions = Questions(chooser, arguments.Question, arguments.Verifications).ToList();
            var runner = new ChartRunner(shaders);
            for (int i = 0; i < questions.Count; i++)
            {
                ChoiceOption answer = chooser.Answer(questions[i]).Best;
                var row = new VerificationRow(questions[i], answer) { Seed = FirstSeed + i, ChartDate = chart.Date };
                yield return MeasurePace(row);
                yield return Measure(runner, row);
                table.Add(row);
                Say(i + 1, questions.Count, row);
            }
            int errors = table.Rows.Count(r => r.ErrorWithin), times = table.Rows.Count(r => r.TimeWithin);
            int paced = table.Rows.Count(r => VerificationRow.IsNear(r.TimeRatio / r.Pace));
            progress
                .Say(string.Format(CultureInfo.InvariantCulture,
                    "Errors within their interval: {0} of {1}; times within {2:0} %: {3} of {1}, " +
                "with the device's pace of the moment taken out {4} of {1}. {5} is written.",
                errors, table.Rows.Count, 100.0 * VerificationRow.TimeTolerance, times, paced, VerificationRow.Format.FileName));
        }

        /// <summary>
        /// Questions that the chart can answer, of all cases or of one in turn: every other one asks for an error, the rest for a time,
        /// somewhere between the least and the largest of what was measured, rounded to two digits.
        /// </summary>
        internal static IEnumerable<ChoiceQuestion> Questions(Chooser chooser, ChoiceQuestion common, int count)
        {
            List<ValidationCase> cases = chooser.Cases.Where(c => common.Case == null || c == common.Case).ToList();
            int asked = 0;
            for (int i = 0; asked < count && i < 20 * count && cases.Count > 0; i++)
            {
                ValidationCase validationCase = cases[i % cases.Count];
                // The next round of the same case asks for the other.
                bool byError = (i % cases.Count + i / cases.Count) % 2 == 0;
                ChoiceQuestion question = Ask(chooser, validationCase, common, byError, shares[i % shares.Length]);
                if (question == null) continue;
                asked++;
                yield return question;
            }
        }

        private static ChoiceQuestion Ask(Chooser chooser, ValidationCase validationCase, ChoiceQuestion common, bool byError, double share)
        {
            var open = new ChoiceQuestion
            {
                Case = validationCase, Error = double.PositiveInfinity, Compression = common.Compression,
                FramesPerSecond = common.FramesPerSecond
            };
            List<ChoiceOption> options;
            try
            {
                options = chooser.Answer(open).Options.ToList();
            }
            catch (CommandLineException)
            {
                return null; // nothing so stiff was measured
            }
            List<double> values = options.Select(o => byError ? o.Error.Value : o.Milliseconds.Value).ToList();
            double least = values.Min(), most = values.Max();
            for (; share <= 1.0; share += 0.1)
            {
                double value = Rounded(least * System.Math.Pow(most / least, share));
                var question = new ChoiceQuestion
                {
                    Case = validationCase, Compression = common.Compression,
                    FramesPerSecond = common.FramesPerSecond
                };
                (question.Error, question.Milliseconds) = byError ? (System.Math.Max(value, validationCase.Floor), double.NaN)
                    : (double.NaN, value);
                ChoiceOption best = chooser.Answer(question).Best;
                double limit = LongestSeconds * (FluidSupport.IsSoftwareDevice ? StepWork.SoftwareRate : StepWork.CardRate);
                if (best != null && new ChartRun(best.ConfigOf(validationCase), 1).Cost <= limit) return question;
                if (!byError) share -= 0.2; // a shorter time, until a run of it is short enough
                if (share < 0.0) break;
            }
            return null;
        }

        private static double Rounded(double value) =>
            double.Parse(value.ToString("G2", CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);

        private IEnumerator MeasurePace(VerificationRow row)
        {
            CaseMethod standard = CaseMethod.Find("standard");
            if (!(chart.CostOf(standard) is StepCostModel cost)) yield break;
            yield return new StepCostRun(shaders).Run(new StepCostPoint(standard, PaceRatio, PaceParticles),
                r => row.Pace = r.Milliseconds / cost.At(PaceParticles, PaceRatio));
        }

        private static IEnumerator Measure(ChartRunner runner, VerificationRow row)
        {
            var run = new ChartRun(row.Answer.ConfigOf(row.Question.Case), row.Seed);
            row.Particles = run.Config.Particles;
            CaseResult result = null;
            yield return runner.Run(run, r => result = r);
            row.Reason = result.Failure ?? "";
            row.MeasuredMilliseconds = result.GpuMsPerSecond / row.Question.FramesPerSecond;
            row.TimeSpread = result.GpuTimes.Spread;
            if (!result.Failed && result.Errors.Count > 0) row.MeasuredError = System.Math.Abs(result.Errors[0].Value);
        }

        private void Say(int number, int count, VerificationRow row)
        {
            ChoiceQuestion question = row.Question;
            string asked = double.IsNaN(question.Error) ? string.Format(CultureInfo.InvariantCulture, "{0:G3} ms", question.Milliseconds)
                : ChoiceText.Error(question.Error, question);
            progress
                .Say(string.Format(CultureInfo.InvariantCulture,
                    "{0}/{1}  {2} for {3}: {4}: error {5}, expected {6} ({7} to {8}){9}; {10:G3} ms, expected {11:G3}{12}, pace {13:G3}",
                number, count, question.Case.Name, asked, row.Answer, ChoiceText.Error(row.MeasuredError, question),
                ChoiceText.Error(row.Answer.Error.Value, question),
                ChoiceText.Error(row.Answer.Error.Low, question), ChoiceText.Error(row.Answer.Error.High, question),
                row.ErrorWithin ? "" : ", outside",
                row.MeasuredMilliseconds, row.Answer.Milliseconds.Value, row.TimeWithin ? "" : ", beyond 30 %", row.Pace));
        }
    }
}
