using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A line of peers.csv: one error of one run of another program.</summary>
    internal sealed class PeerRow : MeasuredRow
    {
        /// <summary>The file.</summary>
        public static readonly TableFormat<PeerRow> Format = new TableFormat<PeerRow>("peers.csv")
            .Text("case", r => r.Case, (r, v) => r.Case = v)
            .Text("method", r => r.Method, (r, v) => r.Method = v)
            .Number("dx", r => r.Spacing, (r, v) => r.Spacing = v)
            .Number("kappa", r => r.Facts.SupportRatio, (r, v) => r.Facts.SupportRatio = v)
            .Number("c_or_iterations", r => r.SoundSpeedRatio, (r, v) => r.SoundSpeedRatio = v)
            .Count("particles", r => r.Particles, (r, v) => r.Particles = v)
            .Count("boundary_particles", r => r.Facts.BoundaryParticles, (r, v) => r.Facts.BoundaryParticles = v)
            .Count("seed", r => r.Seed, (r, v) => r.Seed = checked((int)v))
            .Number("wall_ms_per_sim_s", r => r.WallMsPerSecond, (r, v) => r.WallMsPerSecond = v)
            .Number("error", r => r.Error, (r, v) => r.Error = v)
            .Text("error_name", r => r.ErrorName, (r, v) => r.ErrorName = v)
            .Flag("failed", r => r.Failed, (r, v) => r.Failed = v)
            .Text("reason", r => r.Reason, (r, v) => r.Reason = v)
            .Text("device", r => r.Device, (r, v) => r.Device = v)
            .Text("date", r => r.Date, (r, v) => r.Date = v)
            .Count("steps", r => r.Facts.Steps, (r, v) => r.Facts.Steps = v)
            .Number("dt_s", r => r.TimeStep, (r, v) => r.TimeStep = v)
            .Count("evaluations", r => r.Facts.Evaluations, (r, v) => r.Facts.Evaluations = v)
            .Number("set_up_s", r => r.Facts.SetUpSeconds, (r, v) => r.Facts.SetUpSeconds = v)
            .Number("other_cores", r => r.Facts.OtherCores, (r, v) => r.Facts.OtherCores = v)
            .Number("wall_ms_low", r => r.WallMsLow, (r, v) => r.WallMsLow = v)
            .Number("wall_ms_high", r => r.WallMsHigh, (r, v) => r.WallMsHigh = v)
            .Text("version", r => r.Facts.Version, (r, v) => r.Facts.Version = v);

        /// <summary>Name of the case.</summary>
        public string Case;

        /// <summary>Name of the program and its scheme.</summary>
        public string Method;

        /// <summary>Particle spacing dx [m].</summary>
        public double Spacing;

        /// <summary>Speed of sound over the case's own speed.</summary>
        public double SoundSpeedRatio;

        /// <summary>Number of particles of the liquid.</summary>
        public long Particles;

        /// <summary>Seed of the start's jitter.</summary>
        public int Seed;

        /// <summary>Time by the clock per simulated second, the median of the stretches between samples [ms/s].</summary>
        public double WallMsPerSecond;

        /// <summary>Lower quartile of the stretches, as <see cref="WallMsPerSecond"/> [ms/s].</summary>
        public double WallMsLow;

        /// <summary>Upper quartile of the stretches [ms/s].</summary>
        public double WallMsHigh;

        /// <summary>Mean length of a step [s].</summary>
        public double TimeStep;

        /// <summary>The error, a fraction unless its name has a unit; not a number when there is none.</summary>
        public double Error;

        /// <summary>Name of the error.</summary>
        public string ErrorName;

        /// <summary>Whether the run failed.</summary>
        public bool Failed;

        /// <summary>Why; empty when it did not.</summary>
        public string Reason;

        /// <summary>The rest of what the program told of its run.</summary>
        public PeerFacts Facts = new PeerFacts();

        /// <summary>Equal for all errors of a run.</summary>
        public override string Key => PeerPoint.KeyOf(Case, Method, Spacing, SoundSpeedRatio, Seed);

        /// <summary>The lines of a run: one for each error, the main one first; one without an error when it has none.</summary>
        /// <param name="point">What was run.</param>
        /// <param name="facts">What the program told of it.</param>
        /// <param name="times">Times of its steps.</param>
        /// <param name="result">What the case's metric found.</param>
        public static PeerRow[] Of(PeerPoint point, PeerFacts facts, in StepTimes times, CaseResult result)
        {
            ValidationCase validationCase = point.Peer.Case;
            IReadOnlyList<CaseError> errors = result.Errors.Count > 0 ? result.Errors
                : new[] { new CaseError(validationCase.ErrorName, double.NaN) };
            (double median, double low, double high) =
                (times.Median / facts.TimeStep, times.Low / facts.TimeStep, times.High / facts.TimeStep);
            bool unmeasured = double.IsNaN(errors[0].Value) || double.IsInfinity(errors[0].Value);
            return errors.Select(error => new PeerRow
            {
                Case = validationCase.Name,
                Method = point.Peer.Method,
                Spacing = point.Setup.Settings.Spacing,
                SoundSpeedRatio = point.Parameters.SoundSpeedRatio,
                Particles = result.Particles,
                Seed = point.Parameters.Seed,
                WallMsPerSecond = median,
                WallMsLow = low,
                WallMsHigh = high,
                TimeStep = facts.TimeStep,
                Error = error.Value,
                ErrorName = error.Name,
                Failed = result.Failed || unmeasured,
                Reason = result.Failure ?? (unmeasured ? $"{errors[0].Name} could not be measured" : ""),
                Facts = facts,
            }).ToArray();
        }
    }
}
