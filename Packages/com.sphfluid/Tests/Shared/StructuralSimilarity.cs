using System;

namespace SphFluid.Tests
{
    /// <summary>
    /// How alike two pictures look: 1 for equal ones. Z. Wang, A. C. Bovik, H. R. Sheikh, E. P. Simoncelli, Image quality assessment: from
    /// error visibility to structural similarity, IEEE Transactions on Image Processing 13 (2004), with their window and constants.
    /// </summary>
    internal static class StructuralSimilarity
    {
        /// <summary>Of a window's middle: its edge is 11 pixels.</summary>
        public const int Radius = 5;

        private const double Deviation = 1.5;
        private const double C1 = 0.01 * 0.01;
        private const double C2 = 0.03 * 0.03;

        private static readonly double[] weights = Gaussian();

        /// <summary>Mean over all windows that lie within the pictures.</summary>
        public static double Of(Picture a, Picture b)
        {
            if (a.Width != b.Width || a.Height != b.Height)
            {
                throw new ArgumentException($"{a.Width} x {a.Height} and {b.Width} x {b.Height} pixels");
            }
            double sum = 0.0;
            int count = 0;
            for (int y = Radius; y < a.Height - Radius; y++)
            {
                for (int x = Radius; x < a.Width - Radius; x++)
                {
                    sum += At(a, b, x, y);
                    count++;
                }
            }
            return sum / count;
        }

        /// <summary>Of the window around a pixel.</summary>
        public static double At(Picture a, Picture b, int x, int y)
        {
            double meanA = 0.0, meanB = 0.0, squareA = 0.0, squareB = 0.0, product = 0.0;
            for (int j = -Radius; j <= Radius; j++)
            {
                for (int i = -Radius; i <= Radius; i++)
                {
                    double weight = weights[i + Radius] * weights[j + Radius];
                    double p = a.Luma(x + i, y + j), q = b.Luma(x + i, y + j);
                    meanA += weight * p;
                    meanB += weight * q;
                    squareA += weight * p * p;
                    squareB += weight * q * q;
                    product += weight * p * q;
                }
            }
            double varianceA = squareA - meanA * meanA, varianceB = squareB - meanB * meanB, covariance = product - meanA * meanB;
            return (2.0 * meanA * meanB + C1) * (2.0 * covariance + C2) /
                ((meanA * meanA + meanB * meanB + C1) * (varianceA + varianceB + C2));
        }

        private static double[] Gaussian()
        {
            var values = new double[2 * Radius + 1];
            double sum = 0.0;
            for (int i = -Radius; i <= Radius; i++) sum += values[i + Radius] = Math.Exp(-0.5 * i * i / (Deviation * Deviation));
            for (int i = 0; i < values.Length; i++) values[i] /= sum;
            return values;
        }
    }
}
