using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>
    /// Follows the first Fourier mode of the surface elevation and fits a damped oscillation to it. The mode is taken from
    /// the liquid's volume over x, ∫ h(x) cos kx dx, as the sum (2 H/N) Σ cos k x_i over all N particles, which gives the
    /// amplitude a of h = H + a cos kx exactly and needs no search for the surface.
    /// </summary>
    public sealed class StandingWaveMetric : CaseMetric
    {
        internal const string ErrorName = "period";

        // Of H: a compression that no set-up of the sound speed explains.
        private const double LeastDepth = 0.6;

        private readonly double floor, depth, waveNumber, frequency, viscosity, amplitude, begin;
        private readonly List<double> times = new List<double>();
        private readonly List<double> modes = new List<double>();

        /// <summary>A metric for one run.</summary>
        /// <param name="floor">Height of the floor [m], simulation space.</param>
        /// <param name="depth">Depth H at rest [m].</param>
        /// <param name="waveNumber">k [1/m].</param>
        /// <param name="frequency">Exact ω [1/s].</param>
        /// <param name="viscosity">ν set [m²/s].</param>
        /// <param name="amplitude">Amplitude at the start [m].</param>
        /// <param name="begin">Time from which the oscillation is fitted [s].</param>
        public StandingWaveMetric(double floor, double depth, double waveNumber, double frequency, double viscosity, double amplitude,
            double begin)
        {
            this.floor = floor;
            this.depth = depth;
            this.waveNumber = waveNumber;
            this.frequency = frequency;
            this.viscosity = viscosity;
            this.amplitude = amplitude;
            this.begin = begin;
        }

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
            double sum = 0.0, height = 0.0;
            for (int i = 0; i < state.Count; i++)
            {
                sum += Math.Cos(waveNumber * state.LocalPositions[i].x);
                height += 2.0 * (state.LocalPositions[i].y - floor) / state.Count;
            }
            if (!(height > LeastDepth * depth))
            {
                Failure = FormattableString.Invariant($"the liquid has sunk to {100.0 * height / depth:0} % of its depth");
            }
            times.Add(time);
            modes.Add(2.0 * depth * sum / state.Count);
        }

        /// <summary>
        /// |T/T_exact − 1|; what damps besides the set viscosity, from the amplitude's rate γ = 2 ν k² (its square, the energy,
        /// falls as e^(−4νk²t)); what the fit leaves.
        /// </summary>
        public override IReadOnlyList<CaseError> Evaluate()
        {
            int first = times.FindIndex(t => t >= begin);
            DampedOscillationFit fit = first < 0
                ? null
                : DampedOscillationFit.Of(times.GetRange(first, times.Count - first),
                    modes.GetRange(first, times.Count - first), frequency, "standing-wave", "the first mode");
            double period = fit == null ? double.NaN : frequency / fit.Frequency - 1.0;
            double effective = fit == null ? double.NaN : fit.DampingRate / (2.0 * waveNumber * waveNumber);
            return new[]
            {
                new CaseError(ErrorName, Math.Abs(period)),
                new CaseError("period, T/T_exact − 1", period),
                new CaseError("numerical viscosity/ν", effective / viscosity - 1.0),
                new CaseError("numerical viscosity [m²/s]", effective - viscosity),
                new CaseError("left by the fit", fit?.Residual ?? double.NaN),
            };
        }

        /// <inheritdoc/>
        public override IReadOnlyList<CaseSeries> Series()
        {
            var measured = new CaseSeries("first mode");
            var exact = new CaseSeries("linear wave", true);
            for (int i = 0; i < times.Count; i++)
            {
                double decay = Math.Exp(-2.0 * viscosity * waveNumber * waveNumber * times[i]);
                measured.Add(times[i], modes[i] / amplitude);
                exact.Add(times[i], decay * Math.Cos(frequency * times[i]));
            }
            return new[] { exact, measured };
        }
    }
}
