using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>The function C + e^(−γt) (A cos ωt + B sin ωt) of least squares through samples.</summary>
    public sealed class DampedOscillationFit
    {
        private const int FrequencySteps = 90;
        private const int RateSteps = 30;
        private const double LowestFrequency = 0.25, HighestFrequency = 2.5; // over the expected one
        private const double LowestRate = -0.2, HighestRate = 1.0;           // over the expected frequency

        private DampedOscillationFit()
        {
        }

        /// <summary>ω [1/s].</summary>
        public double Frequency { get; private set; }

        /// <summary>γ [1/s].</summary>
        public double DampingRate { get; private set; }

        /// <summary>C, what it swings about, in the samples' unit.</summary>
        public double Constant { get; private set; }

        /// <summary>√(A² + B²), in the samples' unit.</summary>
        public double Amplitude { get; private set; }

        /// <summary>Root mean square of what is left over that of the samples about their mean.</summary>
        public double Residual { get; private set; }

        /// <summary>2π/ω [s].</summary>
        public double Period => 2.0 * Math.PI / Frequency;

        /// <summary>
        /// Fits. ω and γ are scanned in the ranges ω/ω0 = 0.25 to 2.5, γ/ω0 = −0.2 to 1 and refined by halving steps;
        /// A, B and C follow from each pair by linear least squares.
        /// </summary>
        /// <param name="times">Times of the samples [s].</param>
        /// <param name="values">Samples.</param>
        /// <param name="expectedFrequency">ω0 [1/s].</param>
        /// <returns>The fit; null with fewer than eight samples, or without an oscillation: constant samples, the best ω at the end of
        /// its range, or more than half of the variance left.</returns>
        public static DampedOscillationFit Of(IReadOnlyList<double> times, IReadOnlyList<double> values, double expectedFrequency)
        {
            double variance = Variance(values, out double mean);
            if (values.Count < 8 || !(variance > 1e-20 * mean * mean) || double.IsInfinity(variance)) return null;

            double stepW = (HighestFrequency - LowestFrequency) / FrequencySteps * expectedFrequency;
            double stepG = (HighestRate - LowestRate) / RateSteps * expectedFrequency;
            double bestW = 0.0, bestG = 0.0, best = double.PositiveInfinity;
            for (int i = 0; i <= FrequencySteps; i++)
            {
                for (int j = 0; j <= RateSteps; j++)
                {
                    Try(LowestFrequency * expectedFrequency + i * stepW, LowestRate * expectedFrequency + j * stepG);
                }
            }
            while (stepW > 1e-9 * expectedFrequency)
            {
                double before = best, centreW = bestW, centreG = bestG;
                for (int i = -1; i <= 1; i++)
                {
                    for (int j = -1; j <= 1; j++) Try(centreW + i * stepW, centreG + j * stepG);
                }
                if (!(best < before))
                {
                    stepW *= 0.5;
                    stepG *= 0.5;
                }
            }
            bool inside = bestW > LowestFrequency * expectedFrequency && bestW < HighestFrequency * expectedFrequency;
            if (!inside || !(best < 0.5 * values.Count * variance)) return null;
            double[] c = Linear(times, values, bestW, bestG, out _);
            return new DampedOscillationFit
            {
                Frequency = bestW,
                DampingRate = bestG,
                Constant = c[2],
                Amplitude = Math.Sqrt(c[0] * c[0] + c[1] * c[1]),
                Residual = Math.Sqrt(best / values.Count / variance),
            };

            void Try(double w, double g)
            {
                if (Linear(times, values, w, g, out double squares) != null && squares < best)
                {
                    best = squares;
                    bestW = w;
                    bestG = g;
                }
            }
        }

        // A, B, C and the sum of the squares left, by the normal equations.
        private static double[] Linear(IReadOnlyList<double> times, IReadOnlyList<double> values, double w, double g, out double squares)
        {
            var matrix = new double[3, 4];
            var basis = new double[3];
            for (int s = 0; s < times.Count; s++)
            {
                Basis(times[s], w, g, basis);
                for (int i = 0; i < 3; i++)
                {
                    for (int j = 0; j < 3; j++) matrix[i, j] += basis[i] * basis[j];
                    matrix[i, 3] += basis[i] * values[s];
                }
            }
            squares = 0.0;
            double[] c = LinearSystem.Solve(matrix);
            for (int s = 0; c != null && s < times.Count; s++)
            {
                Basis(times[s], w, g, basis);
                double left = values[s] - c[0] * basis[0] - c[1] * basis[1] - c[2] * basis[2];
                squares += left * left;
            }
            return c;
        }

        private static void Basis(double t, double w, double g, double[] basis)
        {
            double decay = Math.Exp(-g * t);
            basis[0] = decay * Math.Cos(w * t);
            basis[1] = decay * Math.Sin(w * t);
            basis[2] = 1.0;
        }

        private static double Variance(IReadOnlyList<double> values, out double mean)
        {
            mean = 0.0;
            double squares = 0.0;
            foreach (double value in values) mean += value / values.Count;
            foreach (double value in values) squares += (value - mean) * (value - mean) / values.Count;
            return squares;
        }
    }
}
