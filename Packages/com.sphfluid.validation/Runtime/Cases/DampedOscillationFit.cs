using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>The function C + e^(−γt) (A cos ωt + B sin ωt) of least squares through samples.</summary>
    public sealed class DampedOscillationFit
    {
        private const double FrequencyStep = 0.025, RateStep = 0.04; // over the expected frequency
        private const double Beyond = 1.5;                           // of the range of frequencies that is sought
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
        /// Fits. ω/ω0 may be 0.25 to 2.5 and γ/ω0 −0.2 to 1; both are scanned, and refined by halving steps wherever that leads. A, B and C
        /// follow from each pair by linear least squares.
        /// </summary>
        /// <param name="times">Times of the samples [s].</param>
        /// <param name="values">Samples.</param>
        /// <param name="expectedFrequency">ω0 [1/s].</param>
        /// <param name="validationCase">Name of the case whose fit it is.</param>
        /// <param name="what">What swings, for instance "the first mode".</param>
        /// <returns>The fit; null with fewer than eight samples, or without an oscillation: constant samples, or more than half of the
        /// variance left.</returns>
        /// <exception cref="SearchBoundException">The best ω or γ lies at a bound of its range or outside.</exception>
        public static DampedOscillationFit Of(IReadOnlyList<double> times, IReadOnlyList<double> values, double expectedFrequency,
            string validationCase, string what)
        {
            double variance = Variance(values, out double mean);
            if (values.Count < 8 || !(variance > 1e-20 * mean * mean) || double.IsInfinity(variance)) return null;

            double bestW = 0.0, bestG = 0.0, best = double.PositiveInfinity;
            for (double w = LowestFrequency / Beyond; w <= HighestFrequency * Beyond; w += FrequencyStep)
            {
                for (double g = LowestRate; g <= HighestRate; g += RateStep) Try(w * expectedFrequency, g * expectedFrequency);
            }
            double stepW = FrequencyStep * expectedFrequency, stepG = RateStep * expectedFrequency;
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
            if (!(best < 0.5 * values.Count * variance)) return null;
            Range("frequency", LowestFrequency, HighestFrequency).Require(bestW / expectedFrequency);
            Range("damping rate", LowestRate, HighestRate).Require(bestG / expectedFrequency);
            double[] c = Linear(times, values, bestW, bestG, out _);
            return new DampedOscillationFit
            {
                Frequency = bestW,
                DampingRate = bestG,
                Constant = c[2],
                Amplitude = Math.Sqrt(c[0] * c[0] + c[1] * c[1]),
                Residual = Math.Sqrt(best / values.Count / variance),
            };

            SearchRange Range(string quantity, double low, double high) => new SearchRange(validationCase,
                $"the {quantity} of {what} over the expected frequency", low, high,
                $"Look at its curves: where {what} does not swing as it should, the run is wrong; else widen the range in " +
                "DampedOscillationFit.");

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
