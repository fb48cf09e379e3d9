using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>An answer in words, for the console and the Editor's window.</summary>
    public static class ChoiceText
    {
        /// <summary>The lines of an answer.</summary>
        public static IEnumerable<string> Lines(ChoiceAnswer answer)
        {
            ChoiceQuestion question = answer.Question;
            yield return $"{question.Case.Title} ({question.Case.Name}), {question.Case.ErrorName}; measured on {answer.Chart.Device}, " +
                $"{answer.Chart.Date}, in {answer.Chart.Folder}.";
            List<ChoiceOption> shown = Shown(answer).ToList();
            if (answer.Best != null)
            {
                yield return "Choose " + answer.Best + ": " + Figures(answer.Best, question) + ".";
            }
            else
            {
                yield return Nothing(answer);
                foreach ((string what, ChoiceOption option, string why) in Nearest(answer))
                {
                    yield return $"  {what}: {option}: {Figures(option, question)}{why}";
                }
            }
            foreach (string line in shown.SelectMany(o => Notes(answer, o)).Distinct()) yield return line;
            if (shown.Any(o => o.IsBeyondMeasured))
            {
                yield return "That many particles were not timed on this device: the cost is an extrapolation, not measured.";
            }
            foreach (ChoiceOption option in answer.PerMethod.Except(shown))
            {
                string prefix = !Meets(option, question) ? "short of it," : answer.Holds(option) ? "also" : "in the main error alone,";
                yield return $"  {prefix} {option}: {Figures(option, question)}{Beyond(answer, option, "; but ")}";
            }
        }

        /// <summary>The answer, or what is nearest.</summary>
        internal static IEnumerable<ChoiceOption> Shown(ChoiceAnswer answer) =>
            answer.Best != null ? new[] { answer.Best } : Nearest(answer).Select(n => n.Option);

        // What a reader must know of a way besides its figures.
        private static IEnumerable<string> Notes(ChoiceAnswer answer, ChoiceOption option)
        {
            ChoiceQuestion question = answer.Question;
            if (option.Beside.Count > 0)
            {
                string end = answer.Holds(option) ? "." : ". Nothing that was measured holds all of it.";
                yield return $"  Beside it, {option.Method} at {option.Spacing.ToString("G3", CultureInfo.InvariantCulture)} m: " +
                    Beside(question.Case, option, _ => true) + end;
            }
            if (option.Error.Value <= question.Case.Floor)
            {
                yield return $"  {Error(question.Case.Floor, question)} is not the liquid's error but what the reference is good for: " +
                    $"{question.Case.FloorSource}.";
            }
            if (!ChoiceNarrowing.IsWide(option, question.Case)) yield break;
            IReadOnlyList<ChartRun> runs = ChoiceNarrowing.Runs(option, question.Case);
            yield return string.Format(CultureInfo.InvariantCulture, "  An interval is a factor of {0:0.#} wide; ",
                ChoiceNarrowing.Width(option, question.Case)) + (runs.Count == 0
                ? "its own runs differ so much, or a finer spacing errs more, and no other run narrows it."
                : $"what narrows it is {runs[0].Config}, seeds {string.Join(", ", runs.Select(r => r.Seed))}: add --narrow.");
        }

        private static string Beyond(ChoiceAnswer answer, ChoiceOption option, string before) => answer.Holds(option) ? ""
            : before + Beside(answer.Question.Case, option, off => !(off <= answer.Question.Error));

        private static string Beside(ValidationCase validationCase, ChoiceOption option, System.Func<double, bool> isNamed) =>
            string.Join(", ", validationCase.AlsoHeld.Zip(option.Beside, (held, off) => (held, off)).Where(b => isNamed(b.off))
                .Select(b => $"{b.held.Name} {(double.IsNaN(b.off) ? "not measured" : "off by " + Percent(b.off))}"));

        private static string Percent(double value) =>
            (100.0 * value).ToString(value < 0.995 ? "G2" : "0", CultureInfo.InvariantCulture) + " %";

        private static string Nothing(ChoiceAnswer answer)
        {
            string asked = Asked(answer.Question);
            bool each = answer.Fastest != null && answer.MostAccurate != null;
            return $"Nothing that was measured keeps {asked}{(each ? " at once" : "")} in five runs of six. The nearest:";
        }

        private static IEnumerable<(string What, ChoiceOption Option, string Why)> Nearest(ChoiceAnswer answer)
        {
            if (answer.Fastest != null)
                yield return ("with that error", answer.Fastest, "");
            else if (!double.IsNaN(answer.Question.Error))
                yield return ("the least error that was measured", answer.Finest, "; a finer spacing was not measured");
            if (answer.MostAccurate != null)
                yield return ("within that time", answer.MostAccurate, "");
            else if (!double.IsNaN(answer.Question.Milliseconds))
                yield return ("the least time that was measured", answer.QuickestOfAll, "; a coarser spacing was not measured");
        }

        private static bool Meets(ChoiceOption option, ChoiceQuestion question) =>
            !(option.Error.Likely > question.Error) && !(option.Milliseconds.Likely > question.Milliseconds);

        private static string Asked(ChoiceQuestion question)
        {
            var parts = new List<string>();
            if (!double.IsNaN(question.Error)) parts.Add("an error of at most " + Error(question.Error, question));
            if (!double.IsNaN(question.Milliseconds))
            {
                parts.Add(string.Format(CultureInfo.InvariantCulture, "at most {0:G3} ms a frame", question.Milliseconds));
            }
            return string.Join(" and ", parts);
        }

        private static string Figures(ChoiceOption option, ChoiceQuestion question) => string.Format(CultureInfo.InvariantCulture,
            "error {0} ({1} to {2}), {3:G3} ms a frame ({4:G3} to {5:G3}), {6} particles, {7:G3} steps a frame of 1/{8:G4} s",
            Error(option.Error.Value, question), Error(option.Error.Low, question), Error(option.Error.High, question),
            option.Milliseconds.Value, option.Milliseconds.Low, option.Milliseconds.High, ChartAxis.Short(option.Particles),
            option.StepsPerFrame, question.FramesPerSecond);

        /// <summary>An error in its unit: "2.1 %", or a number where the error's name has a unit.</summary>
        internal static string Error(double value, ChoiceQuestion question) => IsFraction(question.Case)
            ? Percent(value)
            : string.Format(CultureInfo.InvariantCulture, "{0:G3}", value);

        internal static bool IsFraction(ValidationCase validationCase) =>
            !validationCase.ErrorName.EndsWith("]", System.StringComparison.Ordinal);
    }
}
