using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Follows two equal drops of opposite velocities along x, the first half of the particles one and the second the other: momentum of
    /// a drop against that of a drop on a plate, and what must not change: the sum of momenta, the centre, the energy, the roundness.
    /// </summary>
    public sealed class DropsMetric : CaseMetric
    {
        internal const string ErrorName = "momentum of a drop, RMS over D/U";
        internal const string GrowthName = "largest E/E0 − 1";

        private readonly FluidSolverSettings settings;
        private readonly double speed, diameter, contact;
        private readonly List<double> times = new List<double>();
        private readonly List<double> momenta = new List<double>();
        private readonly MomentumMetric momentum = new MomentumMetric();
        private readonly EnergyMetric energy;
        private readonly ParticleGapsMetric gaps;
        private double[] startCentre;
        private double shift, ovalness;

        /// <summary>A metric for one run.</summary>
        /// <param name="settings">The run's constants.</param>
        /// <param name="speed">Speed U of each drop [m/s].</param>
        /// <param name="diameter">D [m].</param>
        /// <param name="contact">When the drops touch [s].</param>
        public DropsMetric(in FluidSolverSettings settings, double speed, double diameter, double contact)
        {
            this.settings = settings;
            this.speed = speed;
            this.diameter = diameter;
            this.contact = contact;
            energy = new EnergyMetric(settings, 0.0);
            gaps = new ParticleGapsMetric(settings);
        }

        /// <summary>
        /// What a drop on a plate has of its momentum, t* = t U/D after it touched: the force √(1000 π t*/243) e^(−10 t*/3) ρU²D² of
        /// Mitchell, Klewicki, Korkolis and Kinsey 2019, whose integral is all of π/6 ρUD³. 1, 0.881, 0.446 and 0.149 at 0, 0.1, 0.4, 0.8.
        /// </summary>
        /// <param name="time">t*.</param>
        public static double OnAPlate(double time)
        {
            // 1 − P(3/2, x), the regularised incomplete gamma function, by its series.
            const double gamma = 1.3293403881791370; // Γ(5/2)
            double x = 10.0 / 3.0 * Math.Max(0.0, time), term = 1.0, sum = 1.0;
            for (int n = 1; term > 1e-12 * sum; n++)
            {
                term *= x / (1.5 + n);
                sum += term;
            }

            return 1.0 - Math.Pow(x, 1.5) * Math.Exp(-x) / gamma * sum;
        }

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
            momentum.Sample(time, state);
            energy.Sample(time, state);
            gaps.Sample(time, state);
            uint half = (uint)(state.Count / 2);
            double closing = 0.0;
            var centre = new double[3];
            var squares = new double[3];
            for (int i = 0; i < state.Count; i++)
            {
                closing += state.Ids[i] < half ? state.Velocities[i].x : -state.Velocities[i].x;
                Vector3 p = state.LocalPositions[i];
                for (int axis = 0; axis < 3; axis++)
                {
                    centre[axis] += (double)p[axis] / state.Count;
                    squares[axis] += (double)p[axis] * p[axis];
                }
            }

            startCentre = startCentre ?? centre;
            for (int axis = 0; axis < 3; axis++) shift = Math.Max(shift, Math.Abs(centre[axis] - startCentre[axis]) / settings.Spacing);
            ovalness = Math.Abs(Math.Sqrt(squares[1] / squares[2]) - 1.0);
            times.Add((time - contact) * speed / diameter);
            momenta.Add(closing / state.Count / speed);
        }

        /// <summary>
        /// RMS of the momentum's error from touch to D/U later; growth and rest of the energy; drift of the sum of momenta; shift of the
        /// centre; how unround the sheet between the drops is at the end; nearest pairs, and the largest density error over U/c, the
        /// compression of a plane impact.
        /// </summary>
        public override IReadOnlyList<CaseError> Evaluate()
        {
            IReadOnlyList<CaseError> energies = energy.Evaluate(), near = gaps.Evaluate();
            return new[]
            {
                new CaseError(ErrorName, Rms()),
                new CaseError(GrowthName, energies[0].Value),
                new CaseError("E/E0 at the end", energies[1].Value),
                new CaseError(MomentumMetric.ErrorName, momentum.Evaluate()[0].Value),
                new CaseError("shift of the centre/dx", startCentre == null ? double.NaN : shift),
                new CaseError("sheet, height over width − 1", startCentre == null ? double.NaN : ovalness),
                near[0],
                near[1],
                new CaseError("largest density error over U/c", near[3].Value * settings.SoundSpeed / speed),
            };
        }

        /// <inheritdoc/>
        public override IReadOnlyList<CaseSeries> Series()
        {
            var reference = new CaseSeries("a drop on a plate", true);
            var measured = new CaseSeries("momentum");
            for (int i = 0; i < times.Count; i++)
            {
                reference.Add(times[i], OnAPlate(times[i]));
                measured.Add(times[i], momenta[i]);
            }

            return new[] { reference, measured };
        }

        // Not a number where the run is shorter than D/U.
        private double Rms()
        {
            double sum = 0.0;
            int count = 0;
            for (int i = 0; i < times.Count; i++)
            {
                if (times[i] < 0.0 || times[i] > 1.001) continue;
                double error = momenta[i] - OnAPlate(times[i]);
                sum += error * error;
                count++;
            }

            return times.Count > 0 && times[times.Count - 1] > 0.99 ? Math.Sqrt(sum / count) : double.NaN;
        }
    }
}
