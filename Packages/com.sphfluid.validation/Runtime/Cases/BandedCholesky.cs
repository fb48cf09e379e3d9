using System;

namespace SphFluid.Validation
{
    /// <summary>
    /// A symmetric positive definite matrix of which only a band about the diagonal is not zero, and its factor L in A = L Lᵀ.
    /// </summary>
    internal sealed class BandedCholesky
    {
        private readonly int count, band;
        private readonly double[] lower; // row i: columns i − band to i

        /// <summary>A matrix of zeros.</summary>
        /// <param name="count">Rows.</param>
        /// <param name="band">Most that a row's and a column's number of a coefficient differ by.</param>
        public BandedCholesky(int count, int band)
        {
            this.count = count;
            this.band = band;
            lower = new double[count * (band + 1)];
        }

        /// <summary>Adds to a coefficient on or below the diagonal.</summary>
        public void Add(int row, int column, double value) => lower[At(row, column)] += value;

        /// <summary>Makes the factor of the matrix, in its place.</summary>
        /// <exception cref="ArithmeticException">The matrix is not positive definite.</exception>
        public void Factor()
        {
            for (int i = 0; i < count; i++)
            {
                for (int j = Math.Max(0, i - band); j <= i; j++)
                {
                    double sum = lower[At(i, j)];
                    for (int k = Math.Max(0, i - band); k < j; k++) sum -= j - k <= band ? lower[At(i, k)] * lower[At(j, k)] : 0.0;
                    if (i == j && !(sum > 0.0))
                    {
                        throw new ArithmeticException($"The matrix is not positive definite: its row {i} depends on those before it.");
                    }
                    lower[At(i, j)] = i == j ? Math.Sqrt(sum) : sum / lower[At(j, j)];
                }
            }
        }

        /// <summary>Solves A x = b by the factor.</summary>
        /// <param name="x">b, then x.</param>
        public void Solve(double[] x)
        {
            for (int i = 0; i < count; i++)
            {
                for (int k = Math.Max(0, i - band); k < i; k++) x[i] -= lower[At(i, k)] * x[k];
                x[i] /= lower[At(i, i)];
            }
            for (int i = count - 1; i >= 0; i--)
            {
                x[i] /= lower[At(i, i)];
                for (int k = Math.Max(0, i - band); k < i; k++) x[k] -= lower[At(i, k)] * x[i];
            }
        }

        private int At(int row, int column) => row * (band + 1) + column - row + band;
    }
}
