using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A line of choose.csv: the answer, or what is nearest to it, or the best of a method.</summary>
    public sealed class ChoiceRow
    {
        /// <summary>The file.</summary>
        public static readonly TableFormat<ChoiceRow> Format = new TableFormat<ChoiceRow>("choose.csv")
            .Text("role", r => r.role)
            .Text("case", r => r.answer.Question.Case.Name)
            .Text("error_name", r => r.answer.Question.Case.ErrorName)
            .Number("asked_error", r => r.answer.Question.Error)
            .Number("asked_ms", r => r.answer.Question.Milliseconds)
            .Number("fps", r => r.answer.Question.FramesPerSecond)
            .Text("method", r => r.option.Method)
            .Number("kappa", r => r.option.SupportRatio)
            .Number("dx", r => r.option.Spacing)
            .Count("resolution", r => r.option.Resolution)
            .Number("c_over_speed", r => r.option.SoundSpeedRatio)
            .Number("compression", r => r.option.Compression)
            .Number("particles", r => r.option.Particles)
            .Number("steps_per_frame", r => r.option.StepsPerFrame)
            .Number("error", r => r.option.Error.Value)
            .Number("error_low", r => r.option.Error.Low)
            .Number("error_high", r => r.option.Error.High)
            .Number("ms_per_frame", r => r.option.Milliseconds.Value)
            .Number("ms_low", r => r.option.Milliseconds.Low)
            .Number("ms_high", r => r.option.Milliseconds.High)
            .Text("beside", r => string.Join("; ", r.answer.Question.Case.AlsoHeld.Zip(r.option.Beside,
                (held, off) => $"{held.Name}: {CsvText.Text(off)}")))
            .Flag("holds_beside", r => r.answer.Holds(r.option))
            .Flag("beyond_measured", r => r.option.IsBeyondMeasured)
            .Text("device", r => r.answer.Chart.Device)
            .Text("chart_date", r => r.answer.Chart.Date);

        private readonly string role;
        private readonly ChoiceAnswer answer;
        private readonly ChoiceOption option;

        /// <summary>The lines of an answer: the answer itself, what is nearest, and the best of each method.</summary>
        internal static IEnumerable<ChoiceRow> Of(ChoiceAnswer answer)
        {
            if (answer.Best != null) yield return new ChoiceRow("answer", answer, answer.Best);
            if (answer.Best == null && answer.Fastest != null) yield return new ChoiceRow("fastest with the error", answer, answer.Fastest);
            if (answer.Best == null && answer.MostAccurate != null)
            {
                yield return new ChoiceRow("most accurate in the time", answer, answer.MostAccurate);
            }
            foreach (ChoiceOption option in answer.PerMethod) yield return new ChoiceRow("best of its method", answer, option);
        }

        internal ChoiceRow(string role, ChoiceAnswer answer, ChoiceOption option)
        {
            this.role = role;
            this.answer = answer;
            this.option = option;
        }
    }
}
