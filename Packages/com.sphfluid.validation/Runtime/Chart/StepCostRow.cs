namespace SphFluid.Validation
{
    /// <summary>A line of step-costs.csv: the GPU time of a step of a liquid.</summary>
    public sealed class StepCostRow : MeasuredRow
    {
        /// <summary>The file.</summary>
        public static readonly TableFormat<StepCostRow> Format = new TableFormat<StepCostRow>("step-costs.csv")
            .Text("method", r => r.Method, (r, v) => r.Method = v)
            .Number("kappa", r => r.SupportRatio, (r, v) => r.SupportRatio = v)
            .Count("particles", r => r.Particles, (r, v) => r.Particles = checked((int)v))
            .Count("steps", r => r.Steps, (r, v) => r.Steps = v)
            .Number("gpu_ms_per_step", r => r.Milliseconds, (r, v) => r.Milliseconds = v)
            .Number("gpu_ms_low", r => r.Low, (r, v) => r.Low = v)
            .Number("gpu_ms_high", r => r.High, (r, v) => r.High = v)
            .Number("time_spread", r => r.Spread, (r, v) => r.Spread = v)
            .Text("device", r => r.Device, (r, v) => r.Device = v)
            .Text("date", r => r.Date, (r, v) => r.Date = v);

        /// <summary>Name of the method.</summary>
        public string Method { get; private set; }

        /// <summary>κ = R/dx.</summary>
        public double SupportRatio { get; private set; }

        /// <summary>Number of particles.</summary>
        public int Particles { get; private set; }

        /// <summary>Steps that were timed.</summary>
        public long Steps { get; private set; }

        /// <summary>GPU time of a step, the median of the run's parts [ms].</summary>
        public double Milliseconds { get; private set; }

        /// <summary>Lower quartile of the parts [ms].</summary>
        public double Low { get; private set; }

        /// <summary>Upper quartile of the parts [ms].</summary>
        public double High { get; private set; }

        /// <summary>The quartiles' distance over the time.</summary>
        public double Spread { get; private set; }

        /// <inheritdoc/>
        public override string Key => StepCostPoint.KeyOf(Method, SupportRatio, Particles);

        /// <summary>The line of a liquid.</summary>
        /// <param name="point">The liquid.</param>
        /// <param name="steps">Steps that were timed.</param>
        /// <param name="times">Their times.</param>
        public static StepCostRow Of(StepCostPoint point, long steps, in StepTimes times) => new StepCostRow
        {
            Method = point.Method.Name,
            SupportRatio = point.SupportRatio,
            Particles = point.Particles,
            Steps = steps,
            Milliseconds = times.Median,
            Low = times.Low,
            High = times.High,
            Spread = times.Spread,
        };
    }
}
