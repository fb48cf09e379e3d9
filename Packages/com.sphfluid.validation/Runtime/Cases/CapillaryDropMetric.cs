using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// Follows how long a drop is along z against across, ⟨z²⟩ − ½⟨x² + y²⟩ over ⟨r²⟩ about its centre, which is its second mode where the
    /// change is small, and fits a damped oscillation. Lamb's frequency is ω² = 8σ/(ρR³), which by the drop's mass M is 32πσ/(3M);
    /// viscosity damps as e^(−5νt/R²) (H. Lamb, Hydrodynamics, §§ 275 and 355).
    /// </summary>
    public sealed class CapillaryDropMetric : CaseMetric
    {
        internal const string ErrorName = "period";

        private readonly double frequency, damping;
        private readonly List<double> times = new List<double>();
        private readonly List<double> lengths = new List<double>();
        private readonly List<double> radii = new List<double>();

        /// <summary>A metric for one run.</summary>
        /// <param name="tension">σ [N/m].</param>
        /// <param name="mass">M [kg].</param>
        /// <param name="viscosity">ν that is set [m²/s].</param>
        /// <param name="radius">R at rest [m].</param>
        public CapillaryDropMetric(double tension, double mass, double viscosity, double radius)
        {
            frequency = FrequencyOf(tension, mass);
            damping = 5.0 * viscosity / (radius * radius);
        }

        /// <summary>Lamb's ω of the second mode [1/s].</summary>
        internal static double FrequencyOf(double tension, double mass) => Math.Sqrt(32.0 * Math.PI * tension / (3.0 * mass));

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
            double[] sum = new double[3], squares = new double[3];
            for (int i = 0; i < state.Count; i++)
            {
                for (int axis = 0; axis < 3; axis++)
                {
                    double x = state.LocalPositions[i][axis];
                    sum[axis] += x / state.Count;
                    squares[axis] += x * x / state.Count;
                }
            }
            double xx = squares[0] - sum[0] * sum[0], yy = squares[1] - sum[1] * sum[1], zz = squares[2] - sum[2] * sum[2];
            times.Add(time);
            lengths.Add((zz - 0.5 * (xx + yy)) / (xx + yy + zz));
            radii.Add(Math.Sqrt(5.0 / 3.0 * (xx + yy + zz)));
        }

        /// <summary>
        /// |T/T_Lamb − 1|; the same with its sign; the damping rate over ω; that rate less what the set viscosity gives, over ω; the radius
        /// at the end over the start's, less 1; what the fit leaves.
        /// </summary>
        public override IReadOnlyList<CaseError> Evaluate()
        {
            DampedOscillationFit fit = DampedOscillationFit.Of(times, lengths, frequency, "capillary-drop", "the drop");
            double period = frequency / fit?.Frequency - 1.0 ?? double.NaN, rate = fit?.DampingRate ?? double.NaN;
            return new[]
            {
                new CaseError(ErrorName, Math.Abs(period)),
                new CaseError("period, T/T_Lamb − 1", period),
                new CaseError("damping rate over the frequency", rate / frequency),
                new CaseError("damping beyond the set viscosity's over the frequency", (rate - damping) / frequency),
                new CaseError("radius at the end over the start's − 1", radii.Count == 0 ? double.NaN : radii.Last() / radii[0] - 1.0),
                new CaseError("left by the fit", fit?.Residual ?? double.NaN),
            };
        }

        /// <inheritdoc/>
        public override IReadOnlyList<CaseSeries> Series()
        {
            var exact = new CaseSeries("Lamb", true);
            var measured = new CaseSeries("length");
            double start = lengths.Count == 0 ? 1.0 : lengths[0], period = 2.0 * Math.PI / frequency;
            for (int i = 0; i < times.Count; i++)
            {
                exact.Add(times[i] / period, Math.Exp(-damping * times[i]) * Math.Cos(frequency * times[i]));
                measured.Add(times[i] / period, lengths[i] / start);
            }
            return new[] { exact, measured };
        }
    }
}
