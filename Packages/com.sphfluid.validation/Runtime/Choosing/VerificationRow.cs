namespace SphFluid.Validation
{
    /// <summary>A line of choose-verify.csv: a question, its answer, and what a run of the answer gave.</summary>
    public sealed class VerificationRow : MeasuredRow
    {
        /// <summary>How far a time may be from the predicted one.</summary>
        public const double TimeTolerance = 0.3;

        /// <summary>The file.</summary>
        public static readonly TableFormat<VerificationRow> Format = new TableFormat<VerificationRow>("choose-verify.csv")
            .Text("case", r => r.Question.Case.Name)
            .Number("asked_error", r => r.Question.Error)
            .Number("asked_ms", r => r.Question.Milliseconds)
            .Text("method", r => r.Answer.Method)
            .Number("kappa", r => r.Answer.SupportRatio)
            .Number("dx", r => r.Answer.Spacing)
            .Number("c_over_speed", r => r.Answer.SoundSpeedRatio)
            .Count("particles", r => r.Particles)
            .Count("seed", r => r.Seed)
            .Text("error_name", r => r.Question.Case.ErrorName)
            .Number("error", r => r.Answer.Error.Value)
            .Number("error_low", r => r.Answer.Error.Low)
            .Number("error_high", r => r.Answer.Error.High)
            .Number("measured_error", r => r.MeasuredError)
            .Flag("error_within", r => r.ErrorWithin)
            .Number("ms_per_frame", r => r.Answer.Milliseconds.Value)
            .Number("ms_low", r => r.Answer.Milliseconds.Low)
            .Number("ms_high", r => r.Answer.Milliseconds.High)
            .Number("measured_ms", r => r.MeasuredMilliseconds)
            .Number("time_ratio", r => r.TimeRatio)
            .Flag("time_within", r => r.TimeWithin)
            .Number("time_spread", r => r.TimeSpread)
            .Number("pace", r => r.Pace)
            .Number("paced_ratio", r => r.TimeRatio / r.Pace)
            .Text("reason", r => r.Reason)
            .Text("device", r => r.Device)
            .Text("date", r => r.Date)
            .Text("chart_date", r => r.ChartDate);

        internal VerificationRow(ChoiceQuestion question, ChoiceOption answer)
        {
            Question = question;
            Answer = answer;
        }

        /// <summary>What was asked.</summary>
        public ChoiceQuestion Question { get; }

        /// <summary>What was answered.</summary>
        public ChoiceOption Answer { get; }

        /// <summary>Number of particles of the run.</summary>
        public int Particles { get; internal set; }

        /// <summary>Seed of the run: none that the chart had.</summary>
        public int Seed { get; internal set; }

        /// <summary>The run's error; not a number when it failed.</summary>
        public double MeasuredError { get; internal set; } = double.NaN;

        /// <summary>GPU time of a frame of the run [ms].</summary>
        public double MeasuredMilliseconds { get; internal set; } = double.NaN;

        /// <summary>The quartiles' distance over the time, of the run's parts.</summary>
        public double TimeSpread { get; internal set; } = double.NaN;

        /// <summary>
        /// Time of a step of 4,000 particles just before the run over the fitted one: above 1 the device was slower than when the chart was
        /// made.
        /// </summary>
        public double Pace { get; internal set; } = double.NaN;

        /// <summary>Why the run failed; empty when it did not.</summary>
        public string Reason { get; internal set; } = "";

        /// <summary>Day of the chart's last run.</summary>
        public string ChartDate { get; internal set; } = "";

        /// <summary>Whether the error lies within the answer's interval; at or below a reference's floor all errors are one.</summary>
        public bool ErrorWithin => Answer.Error.Contains(MeasuredError) || MeasuredError <= Question.Case.Floor &&
            Answer.Error.Low <= Question.Case.Floor;

        /// <summary>Measured time over the predicted one.</summary>
        public double TimeRatio => MeasuredMilliseconds / Answer.Milliseconds.Value;

        /// <summary>Whether the time is within 30 % of the predicted one.</summary>
        public bool TimeWithin => IsNear(TimeRatio);

        /// <summary>Whether a ratio is within 30 % of one.</summary>
        internal static bool IsNear(double ratio) => ratio >= 1.0 - TimeTolerance && ratio <= 1.0 + TimeTolerance;
    }
}
