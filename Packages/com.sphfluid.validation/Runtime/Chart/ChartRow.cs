using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A line of accuracy.csv: one error of one run.</summary>
    public sealed class ChartRow : MeasuredRow
    {
        /// <summary>The file.</summary>
        public static readonly TableFormat<ChartRow> Format = new TableFormat<ChartRow>("accuracy.csv")
            .Text("case", r => r.Case, (r, v) => r.Case = v)
            .Text("method", r => r.Method, (r, v) => r.Method = v)
            .Number("dx", r => r.Spacing, (r, v) => r.Spacing = v)
            .Number("kappa", r => r.SupportRatio, (r, v) => r.SupportRatio = v)
            .Number("dt_fraction", r => r.TimeStepFraction, (r, v) => r.TimeStepFraction = v)
            .Number("c_or_iterations", r => r.SoundSpeedRatio, (r, v) => r.SoundSpeedRatio = v)
            .Count("particles", r => r.Particles, (r, v) => r.Particles = checked((int)v))
            .Count("seed", r => r.Seed, (r, v) => r.Seed = checked((int)v))
            .Number("gpu_ms_per_sim_s", r => r.GpuMsPerSecond, (r, v) => r.GpuMsPerSecond = v)
            .Number("cpu_ms_per_sim_s", r => r.CpuMsPerSecond, (r, v) => r.CpuMsPerSecond = v)
            .Number("error", r => r.Error, (r, v) => r.Error = v)
            .Text("error_name", r => r.ErrorName, (r, v) => r.ErrorName = v)
            .Flag("failed", r => r.Failed, (r, v) => r.Failed = v)
            .Text("reason", r => r.Reason, (r, v) => r.Reason = v)
            .Text("device", r => r.Device, (r, v) => r.Device = v)
            .Text("date", r => r.Date, (r, v) => r.Date = v)
            .Count("steps", r => r.Steps, (r, v) => r.Steps = v)
            .Later()
            .Number("dt_s", r => r.TimeStep, (r, v) => r.TimeStep = v)
            .Number("gpu_ms_low", r => r.GpuMsLow, (r, v) => r.GpuMsLow = v)
            .Number("gpu_ms_high", r => r.GpuMsHigh, (r, v) => r.GpuMsHigh = v)
            .Number("time_spread", r => r.TimeSpread, (r, v) => r.TimeSpread = v);

        /// <summary>Name of the case.</summary>
        public string Case { get; private set; }

        /// <summary>Name of the method.</summary>
        public string Method { get; private set; }

        /// <summary>Particle spacing dx [m].</summary>
        public double Spacing { get; private set; }

        /// <summary>κ = R/dx.</summary>
        public double SupportRatio { get; private set; }

        /// <summary>Time step over the method's stable one.</summary>
        public double TimeStepFraction { get; private set; }

        /// <summary>Speed of sound over the case's own speed.</summary>
        public double SoundSpeedRatio { get; private set; }

        /// <summary>Number of particles.</summary>
        public int Particles { get; private set; }

        /// <summary>Seed of the start's jitter.</summary>
        public int Seed { get; private set; }

        /// <summary>GPU time per simulated second [ms/s]; not a number when it was not measured.</summary>
        public double GpuMsPerSecond { get; private set; }

        /// <summary>CPU time per simulated second [ms/s]; not a number when it was not measured.</summary>
        public double CpuMsPerSecond { get; private set; }

        /// <summary>The error, a fraction unless its name has a unit; not a number when there is none.</summary>
        public double Error { get; private set; }

        /// <summary>Name of the error.</summary>
        public string ErrorName { get; private set; }

        /// <summary>Whether the run failed.</summary>
        public bool Failed { get; private set; }

        /// <summary>Why, or that this error could not be measured; empty when all is well.</summary>
        public string Reason { get; private set; }

        /// <summary>Steps done.</summary>
        public long Steps { get; private set; }

        /// <summary>Length of a step [s]; not a number in files from before it was written.</summary>
        public double TimeStep { get; private set; } = double.NaN;

        /// <summary>
        /// Lower quartile of the run's parts, as <see cref="GpuMsPerSecond"/> [ms/s]; not a number where it was not measured.
        /// </summary>
        public double GpuMsLow { get; private set; } = double.NaN;

        /// <summary>Upper quartile of the run's parts [ms/s].</summary>
        public double GpuMsHigh { get; private set; } = double.NaN;

        /// <summary>
        /// The quartiles' distance over the time: above <see cref="StepTimes.BusySpread"/> something else used the device.
        /// </summary>
        public double TimeSpread { get; private set; } = double.NaN;

        /// <summary>Equal to the key of its run, which may have several errors.</summary>
        public override string Key => ChartRun.KeyOf(Point, Seed);

        /// <summary>The name of the point: see <see cref="ChartConfig.Key"/>.</summary>
        public string Point => ChartConfig.KeyOf(Case, Method, Spacing, SupportRatio, TimeStepFraction, SoundSpeedRatio);

        /// <summary>The lines of a run: one for each error, the main one first; one without an error when it has none.</summary>
        /// <param name="run">What was run.</param>
        /// <param name="result">What came out.</param>
        public static ChartRow[] Of(ChartRun run, CaseResult result)
        {
            ChartConfig config = run.Config;
            IReadOnlyList<CaseError> errors = result.Errors.Count > 0 ? result.Errors
                : new[] { new CaseError(config.Case.ErrorName, double.NaN) };
            string failure = result.Failure ?? Unmeasured(errors[0]);
            return errors.Select(error => new ChartRow
            {
                Case = config.Case.Name,
                Method = config.Method.Name,
                Spacing = config.Spacing,
                SupportRatio = config.SupportRatio,
                TimeStepFraction = config.TimeStepFraction,
                SoundSpeedRatio = config.SoundSpeedRatio,
                Particles = config.Particles,
                Seed = run.Seed,
                GpuMsPerSecond = result.GpuMsPerSecond,
                CpuMsPerSecond = result.CpuMsPerSecond,
                Error = error.Value,
                ErrorName = error.Name,
                Failed = failure != null,
                Reason = failure ?? Unmeasured(error) ?? "",
                Steps = result.Steps,
                TimeStep = result.TimeStep,
                GpuMsLow = result.GpuTimes.Low / result.TimeStep,
                GpuMsHigh = result.GpuTimes.High / result.TimeStep,
                TimeSpread = result.GpuTimes.Spread,
            }).ToArray();
        }

        private static string Unmeasured(in CaseError error) =>
            double.IsNaN(error.Value) || double.IsInfinity(error.Value) ? $"{error.Name} could not be measured" : null;
    }
}
