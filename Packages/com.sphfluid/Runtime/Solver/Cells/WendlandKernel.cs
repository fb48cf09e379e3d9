using System;

namespace SphFluid
{
    /// <summary>Wendland's C2 kernel in three dimensions, W = 21/(2πR³) (1−q)⁴ (4q+1) (Wendland 1995), and what follows from it.</summary>
    internal static class WendlandKernel
    {
        /// <summary>21 / (2π R³).</summary>
        public static double Factor(double radius) => 21.0 / (2.0 * Math.PI * Math.Pow(radius, 3.0));

        /// <summary>210 / (π R⁵): ∇W = −this (1−q)³ d for the separation d.</summary>
        public static double SlopeFactor(double radius) => 210.0 / (Math.PI * Math.Pow(radius, 5.0));

        /// <summary>W R³ at q = r/R.</summary>
        public static double Shape(double q)
        {
            double u = Math.Max(0.0, 1.0 - q);
            return Factor(1.0) * u * u * u * u * (4.0 * q + 1.0);
        }

        /// <summary>
        /// S = Σ W dx³ over the simple cubic lattice, the particle itself included; 1.0338, 1.0230, 1.0134 for κ = 2, 2.25, 2.5.
        /// </summary>
        /// <param name="ratio">κ = R/dx.</param>
        public static double LatticeSum(double ratio) => OverLattice(ratio, Shape);

        /// <summary>
        /// M = Σ x² (−W'/r) dx³ / S over the same lattice; 0.9501, 0.9763, 0.9664 for κ = 2, 2.25, 2.5, and 1 for many neighbours. What
        /// the sums make of a compression, of a linear pressure's gradient and of a parabola's viscous force is M times the true one.
        /// </summary>
        /// <param name="ratio">κ = R/dx.</param>
        public static double LatticeMoment(double ratio) => OverLattice(ratio, Stretch) / LatticeSum(ratio);

        /// <summary>
        /// R² Σ 2 (−W'/r) dx³ / (S M) over the same lattice, the particle itself left out: what viscosity takes of the velocity of a
        /// particle among others at rest, over ν/R²; 18.2, 20.6, 22.6 for κ = 2, 2.25, 2.5.
        /// </summary>
        /// <param name="ratio">κ = R/dx.</param>
        public static double LatticeViscosity(double ratio)
        {
            double own = SlopeFactor(1.0) / Math.Pow(ratio, 3.0);
            return 2.0 * (OverLattice(ratio, Slope) - own) / (LatticeSum(ratio) * LatticeMoment(ratio));
        }

        // (−W'/r) R⁵.
        private static double Slope(double q)
        {
            double u = Math.Max(0.0, 1.0 - q);
            return SlopeFactor(1.0) * u * u * u;
        }

        /// <summary>
        /// Σ |dx ∇W dx³|² / S² over the same lattice: what the other particles' gradients add to the stiffness of a density constraint,
        /// times dx²; 0.445, 0.312, 0.211 for κ = 2, 2.25, 2.5.
        /// </summary>
        /// <param name="ratio">κ = R/dx.</param>
        public static double LatticeSquares(double ratio) =>
            OverLattice(ratio, Square) / (Math.Pow(ratio, 5.0) * Math.Pow(LatticeSum(ratio), 2.0));

        // |∇W|² R⁸.
        private static double Square(double q)
        {
            double u = Math.Max(0.0, 1.0 - q);
            return Math.Pow(SlopeFactor(1.0) * q * u * u * u, 2.0);
        }

        // x² (−W'/r) R³ in the mean over directions.
        private static double Stretch(double q)
        {
            double u = Math.Max(0.0, 1.0 - q);
            return SlopeFactor(1.0) / 3.0 * q * q * u * u * u;
        }

        // Sum over the points within R, each with dx³/R³, from one octant: points off a plane of it count twice.
        private static double OverLattice(double ratio, Func<double, double> function)
        {
            Require.SupportRatio(ratio);
            int reach = (int)Math.Floor(ratio);
            double sum = 0.0;
            for (int z = 0; z <= reach; z++)
                for (int y = 0; y <= reach; y++)
                    for (int x = 0; x <= reach; x++)
                    {
                        int images = (x > 0 ? 2 : 1) * (y > 0 ? 2 : 1) * (z > 0 ? 2 : 1);
                        sum += images * function(Math.Sqrt(x * x + y * y + z * z) / ratio);
                    }
            return sum / Math.Pow(ratio, 3.0);
        }
    }
}
