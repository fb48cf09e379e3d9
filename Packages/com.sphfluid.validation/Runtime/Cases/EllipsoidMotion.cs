using System;

namespace SphFluid.Validation
{
    /// <summary>
    /// A ball of inviscid liquid under the acceleration −ω² x, set going by u = σ (−x/2, −y/2, z): it stays an ellipsoid, since the
    /// velocity stays linear in x and the pressure p = ρ (λ/2) (1 − Σ (x_i/a_i)²) is zero on its surface. Half axes in radii, time in 1/ω:
    /// a_i″ = −a_i + λ/a_i, λ = (3 + Σ (a_i′/a_i)²)/Σ a_i⁻².
    /// </summary>
    public sealed class EllipsoidMotion
    {
        private const double Step = 0.0025;

        private readonly State[] states;

        /// <summary>The motion from a ball.</summary>
        /// <param name="sigma">σ/ω.</param>
        /// <param name="duration">Length [1/ω].</param>
        public EllipsoidMotion(double sigma, double duration)
        {
            states = new State[(int)Math.Ceiling(duration / Step) + 2];
            states[0] = new State(1.0, 1.0, -0.5 * sigma, sigma);
            for (int i = 1; i < states.Length; i++) states[i] = Advance(states[i - 1]);
            (Period, Least, Greatest) = Extremes();
        }

        /// <summary>Time between the first two maxima of a_z [1/ω]; not a number when they are not within the duration.</summary>
        public double Period { get; }

        /// <summary>Least a_z.</summary>
        public double Least { get; }

        /// <summary>Greatest a_z.</summary>
        public double Greatest { get; }

        /// <summary>Half axis along z.</summary>
        /// <param name="time">Time [1/ω].</param>
        public double AlongZ(double time) => At(time).Z;

        /// <summary>Half axis along x, and along y.</summary>
        /// <param name="time">Time [1/ω].</param>
        public double Across(double time) => At(time).X;

        /// <summary>Rate of the half axis along z [ω].</summary>
        /// <param name="time">Time [1/ω].</param>
        public double RateAlongZ(double time) => At(time).RateZ;

        /// <summary>λ/2, the pressure at the centre [ρ (ωR)²].</summary>
        /// <param name="time">Time [1/ω].</param>
        public double CentrePressure(double time) => 0.5 * Lambda(At(time));

        // One more step of the integrator from the state before: exact to its order at any time.
        private State At(double time)
        {
            if (!(time >= 0.0) || time > (states.Length - 1) * Step)
            {
                throw new ArgumentOutOfRangeException(nameof(time), time, $"The motion is known from 0 to {(states.Length - 1) * Step}.");
            }
            int before = Math.Min((int)(time / Step), states.Length - 1);
            return Advance(states[before], time - before * Step);
        }

        private (double Period, double Least, double Greatest) Extremes()
        {
            double least = 1.0, greatest = 1.0, first = double.NaN, period = double.NaN;
            for (int i = 1; i < states.Length; i++)
            {
                least = Math.Min(least, states[i].Z);
                greatest = Math.Max(greatest, states[i].Z);
                if (!(states[i - 1].RateZ > 0.0) || states[i].RateZ > 0.0) continue;
                double peak = (i - states[i].RateZ / (states[i].RateZ - states[i - 1].RateZ)) * Step;
                if (double.IsNaN(first))
                    first = peak;
                else if (double.IsNaN(period))
                    period = peak - first;
            }
            return (period, least, greatest);
        }

        // Runge-Kutta of fourth order.
        private static State Advance(in State s, double step = Step)
        {
            State k1 = Rate(s), k2 = Rate(s.Plus(k1, 0.5 * step)), k3 = Rate(s.Plus(k2, 0.5 * step)), k4 = Rate(s.Plus(k3, step));
            return s.Plus(k1, step / 6.0).Plus(k2, step / 3.0).Plus(k3, step / 3.0).Plus(k4, step / 6.0);
        }

        private static State Rate(in State s)
        {
            double lambda = Lambda(s);
            return new State(s.RateX, s.RateZ, -s.X + lambda / s.X, -s.Z + lambda / s.Z);
        }

        private static double Lambda(in State s)
        {
            double x = s.RateX / s.X, z = s.RateZ / s.Z;
            return (3.0 + 2.0 * x * x + z * z) / (2.0 / (s.X * s.X) + 1.0 / (s.Z * s.Z));
        }

        private readonly struct State
        {
            public readonly double X, Z, RateX, RateZ;

            public State(double x, double z, double rateX, double rateZ)
            {
                X = x;
                Z = z;
                RateX = rateX;
                RateZ = rateZ;
            }

            public State Plus(in State rate, double step) =>
                new State(X + step * rate.X, Z + step * rate.Z, RateX + step * rate.RateX, RateZ + step * rate.RateZ);
        }
    }
}
