using System;

namespace SphFluid.Validation
{
    /// <summary>Small systems of linear equations.</summary>
    internal static class LinearSystem
    {
        /// <summary>Solves by Gauss–Jordan with pivots.</summary>
        /// <param name="m">n rows of n coefficients and the right side; changed.</param>
        /// <returns>The unknowns; null where the equations do not tell them.</returns>
        public static double[] Solve(double[,] m)
        {
            int count = m.GetLength(0);
            for (int column = 0; column < count; column++)
            {
                int pivot = column;
                for (int row = column + 1; row < count; row++) pivot = Math.Abs(m[row, column]) > Math.Abs(m[pivot, column]) ? row : pivot;
                if (!(Math.Abs(m[pivot, column]) > 1e-12)) return null;
                for (int k = 0; k <= count; k++) (m[column, k], m[pivot, k]) = (m[pivot, k], m[column, k]);
                for (int row = 0; row < count; row++)
                {
                    double factor = row == column ? 0.0 : m[row, column] / m[column, column];
                    for (int k = column; k <= count; k++) m[row, k] -= factor * m[column, k];
                }
            }
            var result = new double[count];
            for (int i = 0; i < count; i++) result[i] = m[i, count] / m[i, i];
            return result;
        }
    }
}
