using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>
    /// Follows the half axis a_z = √(5 ⟨z²⟩) of a ball of particles, over its value at the start, as a cut lattice is no exact ball:
    /// of ⟨z²⟩ about the particles' centre.
    /// </summary>
    public sealed class EllipsoidMetric : CaseMetric
    {
        internal const string ErrorName = "half axis, RMS over one period";

        private readonly EllipsoidMotion exact;
        private readonly double rate;
        private readonly List<double> times = new List<double>();
        private readonly List<double> axes = new List<double>();
        private double start;

        /// <summary>A metric for one run.</summary>
        /// <param name="exact">The right motion, as long as the run.</param>
        /// <param name="rate">ω [1/s].</param>
        public EllipsoidMetric(EllipsoidMotion exact, double rate)
        {
            this.exact = exact ?? throw new ArgumentNullException(nameof(exact));
            this.rate = rate;
        }

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
            double sum = 0.0, squares = 0.0;
            for (int i = 0; i < state.Count; i++)
            {
                double z = state.LocalPositions[i].z;
                sum += z;
                squares += z * z;
            }
            double axis = Math.Sqrt(5.0 * (squares / state.Count - sum * sum / ((double)state.Count * state.Count)));
            if (times.Count == 0) start = axis;
            times.Add(rate * time);
            axes.Add(axis / start);
        }

        /// <summary>
        /// RMS of a_z's error over one period over the range of the exact a_z, 0.702 radii; |error| of the period between the first two
        /// maxima; what is left of the second maximum, (a − 1)/(exact a − 1); the first too.
        /// </summary>
        public override IReadOnlyList<CaseError> Evaluate()
        {
            (double Time, double Height) first = Maximum(0.0, 0.7 * exact.Period);
            (double Time, double Height) second = Maximum(0.7 * exact.Period, double.PositiveInfinity);
            double period = (second.Time - first.Time) / exact.Period - 1.0;
            return new[]
            {
                new CaseError(ErrorName, Rms() / (exact.Greatest - exact.Least)),
                new CaseError("period, |T/T_exact − 1|", Math.Abs(period)),
                new CaseError("period, T/T_exact − 1", period),
                new CaseError("second maximum over the exact one", (second.Height - 1.0) / (exact.Greatest - 1.0)),
                new CaseError("first maximum over the exact one", (first.Height - 1.0) / (exact.Greatest - 1.0)),
            };
        }

        /// <inheritdoc/>
        public override IReadOnlyList<CaseSeries> Series()
        {
            var reference = new CaseSeries("exact", true);
            var measured = new CaseSeries("half axis");
            for (int i = 0; i < times.Count; i++)
            {
                reference.Add(times[i] / rate, exact.AlongZ(times[i]));
                measured.Add(times[i] / rate, axes[i]);
            }
            return new[] { reference, measured };
        }

        // Trapezia; not a number where the run is shorter than a period.
        private double Rms()
        {
            double sum = 0.0;
            for (int i = 1; i < times.Count; i++)
            {
                double from = times[i - 1], to = Math.Min(times[i], exact.Period);
                double share = (to - from) / (times[i] - from);
                double before = Error(i - 1), after = before + share * (Error(i) - before);
                sum += 0.5 * (before * before + after * after) * (to - from);
                if (times[i] >= exact.Period) return Math.Sqrt(sum / exact.Period);
            }
            return double.NaN;
        }

        private double Error(int i) => axes[i] - exact.AlongZ(times[i]);

        // Vertex of the parabola through the highest sample and its neighbours; none at the ends of the window.
        private (double Time, double Height) Maximum(double from, double to)
        {
            int best = -1;
            for (int i = 0; i < times.Count; i++)
            {
                if (times[i] >= from && times[i] <= to && (best < 0 || axes[i] > axes[best])) best = i;
            }
            if (best < 1 || best + 1 >= times.Count || times[best - 1] < from || times[best + 1] > to) return (double.NaN, double.NaN);
            double t0 = times[best - 1] - times[best], t2 = times[best + 1] - times[best];
            double y0 = axes[best - 1] - axes[best], y2 = axes[best + 1] - axes[best];
            // y = b t + c t²
            double c = (y2 / t2 - y0 / t0) / (t2 - t0), b = y0 / t0 - c * t0;
            return c < 0.0 ? (times[best] - 0.5 * b / c, axes[best] - 0.25 * b * b / c) : (times[best], axes[best]);
        }
    }
}
