using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>
    /// Least squares with coefficients that are not negative, for a handful of terms: of all subsets of the terms, the one whose
    /// unconstrained fit has no negative coefficient and the least sum of squares. That is the solution by the conditions of Karush, Kuhn
    /// and Tucker (C. L. Lawson and R. J. Hanson 1974, Solving Least Squares Problems, chapter 23).
    /// </summary>
    internal static class NonnegativeFit
    {
        private const int MostTerms = 10;

        /// <summary>The coefficients.</summary>
        /// <param name="terms">A row of terms for each sample, all of one length.</param>
        /// <param name="values">The value of each sample.</param>
        /// <param name="weights">The weight of each squared residual.</param>
        /// <exception cref="ArgumentException">There are no samples, too many terms, or lengths that differ.</exception>
        public static double[] Solve(IReadOnlyList<double[]> terms, IReadOnlyList<double> values, IReadOnlyList<double> weights)
        {
            if (terms.Count == 0 || terms.Count != values.Count || terms.Count != weights.Count)
            {
                throw new ArgumentException(
                    $"{terms.Count} rows of terms, {values.Count} values and {weights.Count} weights are no samples.");
            }
            int count = terms[0].Length;
            if (count > MostTerms) throw new ArgumentException($"{count} terms are more than {MostTerms}.", nameof(terms));
            double[] scale = Scales(terms, count);
            var best = new double[count];
            double least = Residual(terms, values, weights, best);
            for (int subset = 1; subset < 1 << count; subset++)
            {
                double[] fit = Fit(terms, values, weights, subset, scale);
                if (fit == null || Array.Exists(fit, c => c < 0.0)) continue;
                double residual = Residual(terms, values, weights, fit);
                if (residual < least) (least, best) = (residual, fit);
            }
            return best;
        }

        // Terms of very different size, as 1 and N κ³, would spoil the normal equations.
        private static double[] Scales(IReadOnlyList<double[]> terms, int count)
        {
            var scale = new double[count];
            for (int j = 0; j < count; j++)
            {
                foreach (double[] row in terms) scale[j] = Math.Max(scale[j], Math.Abs(row[j]));
            }
            return scale;
        }

        // Null where the terms of the subset depend on each other.
        private static double[] Fit(IReadOnlyList<double[]> terms, IReadOnlyList<double> values, IReadOnlyList<double> weights, int subset,
            double[] scale)
        {
            var chosen = new List<int>();
            for (int j = 0; j < scale.Length; j++)
            {
                if ((subset & (1 << j)) == 0) continue;
                if (scale[j] == 0.0) return null;
                chosen.Add(j);
            }
            int n = chosen.Count;
            var system = new double[n, n + 1];
            for (int s = 0; s < terms.Count; s++)
            {
                for (int i = 0; i < n; i++)
                {
                    double term = weights[s] * terms[s][chosen[i]] / scale[chosen[i]];
                    for (int j = 0; j < n; j++) system[i, j] += term * terms[s][chosen[j]] / scale[chosen[j]];
                    system[i, n] += term * values[s];
                }
            }
            if (!Eliminate(system, n)) return null;
            var fit = new double[scale.Length];
            for (int i = 0; i < n; i++) fit[chosen[i]] = system[i, n] / scale[chosen[i]];
            return fit;
        }

        // Gauss and Jordan, with the largest pivot; the solution is the last column. False for a singular system.
        private static bool Eliminate(double[,] system, int n)
        {
            double largest = 0.0;
            for (int i = 0; i < n; i++) largest = Math.Max(largest, system[i, i]);
            for (int column = 0; column < n; column++)
            {
                int pivot = column;
                for (int row = column + 1; row < n; row++)
                {
                    pivot = Math.Abs(system[row, column]) > Math.Abs(system[pivot, column]) ? row : pivot;
                }
                if (!(Math.Abs(system[pivot, column]) > 1e-13 * largest)) return false;
                for (int j = 0; j <= n; j++) (system[column, j], system[pivot, j]) = (system[pivot, j], system[column, j]);
                for (int row = 0; row < n; row++)
                {
                    double factor = row == column ? 0.0 : system[row, column] / system[column, column];
                    for (int j = column; j <= n && factor != 0.0; j++) system[row, j] -= factor * system[column, j];
                }
            }
            for (int row = 0; row < n; row++) system[row, n] /= system[row, row];
            return true;
        }

        private static double Residual(IReadOnlyList<double[]> terms, IReadOnlyList<double> values, IReadOnlyList<double> weights,
            double[] fit)
        {
            double sum = 0.0;
            for (int s = 0; s < terms.Count; s++)
            {
                double off = values[s] - Dot(terms[s], fit);
                sum += weights[s] * off * off;
            }
            return sum;
        }

        /// <summary>Σ a_i b_i.</summary>
        internal static double Dot(double[] a, double[] b)
        {
            double sum = 0.0;
            for (int i = 0; i < a.Length; i++) sum += a[i] * b[i];
            return sum;
        }
    }
}
