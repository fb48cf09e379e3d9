using System;

namespace SphFluid.Tests
{
    /// <summary>
    /// A covariance, or a quadratic form, of three axes in double precision, with what stretched kernels need.
    /// </summary>
    internal sealed class Covariance
    {
        private readonly double[,] m = new double[3, 3];

        /// <summary>Of a ball's quadratic form: 1 on a sphere of the radius.</summary>
        public static Covariance Ball(double radius)
        {
            var ball = new Covariance();
            for (int i = 0; i < 3; i++) ball.m[i, i] = 1.0 / (radius * radius);
            return ball;
        }

        /// <summary>Adds weight times d dᵀ.</summary>
        public void Add(double weight, Double3 d)
        {
            double[] v = { d.X, d.Y, d.Z };
            for (int i = 0; i < 3; i++)
            {
                for (int j = 0; j < 3; j++) m[i, j] += weight * v[i] * v[j];
            }
        }

        /// <summary>a · M b.</summary>
        public double Product(Double3 a, Double3 b)
        {
            double[] v = { a.X, a.Y, a.Z }, w = { b.X, b.Y, b.Z };
            double sum = 0.0;
            for (int i = 0; i < 3; i++)
            {
                for (int j = 0; j < 3; j++) sum += v[i] * m[i, j] * w[j];
            }
            return sum;
        }

        /// <summary>
        /// The quadratic form of the ellipsoid with the axes of this covariance, the longest at most a ratio longer
        /// than the others, of a unit ball's volume. Its axes come from turning the matrix about its largest mixed
        /// entry until none is left.
        /// </summary>
        public Covariance Stretched(double ratio)
        {
            var a = (double[,])m.Clone();
            var axes = new double[3, 3];
            for (int i = 0; i < 3; i++) axes[i, i] = 1.0;
            for (int turn = 0; turn < 60; turn++) Turn(a, axes);

            double longest = Math.Max(a[0, 0], Math.Max(a[1, 1], a[2, 2])), volume = 1.0;
            var lengths = new double[3];
            for (int k = 0; k < 3; k++)
            {
                lengths[k] = Math.Max(a[k, k], longest / ratio);
                volume *= lengths[k];
            }
            var stretched = new Covariance();
            for (int k = 0; k < 3; k++)
            {
                double length = lengths[k] / Math.Pow(volume, 1.0 / 3.0);
                stretched.Add(1.0 / (length * length), new Double3(axes[0, k], axes[1, k], axes[2, k]));
            }
            return stretched;
        }

        private static void Turn(double[,] a, double[,] axes)
        {
            int p = 0, q = 1;
            if (Math.Abs(a[0, 2]) > Math.Abs(a[p, q])) (p, q) = (0, 2);
            if (Math.Abs(a[1, 2]) > Math.Abs(a[p, q])) (p, q) = (1, 2);
            double angle = 0.5 * Math.Atan2(2.0 * a[p, q], a[q, q] - a[p, p]), c = Math.Cos(angle), s = Math.Sin(angle);
            for (int k = 0; k < 3; k++) (a[k, p], a[k, q]) = (c * a[k, p] - s * a[k, q], s * a[k, p] + c * a[k, q]);
            for (int k = 0; k < 3; k++) (a[p, k], a[q, k]) = (c * a[p, k] - s * a[q, k], s * a[p, k] + c * a[q, k]);
            for (int k = 0; k < 3; k++) (axes[k, p], axes[k, q]) = (c * axes[k, p] - s * axes[k, q], s * axes[k, p] + c * axes[k, q]);
        }
    }
}
