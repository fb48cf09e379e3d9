using System;

namespace SphFluid
{
    /// <summary>Factors of Müller's kernels, equations (12), (14) and (17), in double precision: h⁹ leaves float's range early.</summary>
    internal static class MullerKernels
    {
        /// <summary>315 / (64 π h⁹), equation (12).</summary>
        public static double Poly6Factor(double h)
        {
            return 315.0 / (64.0 * Math.PI * Math.Pow(h, 9.0));
        }

        /// <summary>45 / (π h⁶): of the gradient of (14) and of the Laplacian (17).</summary>
        public static double SpikyGradientFactor(double h)
        {
            return 45.0 / (Math.PI * Math.Pow(h, 6.0));
        }

        /// <summary>Σ W dx³ of poly6 over the simple cubic lattice of spacing dx, the particle itself included; R = ratio · dx.</summary>
        public static double LatticeSum(double ratio)
        {
            Require.SupportRatio(ratio);
            int reach = (int)Math.Floor(ratio);
            double sum = 0.0;
            for (int z = -reach; z <= reach; z++)
            {
                for (int y = -reach; y <= reach; y++)
                {
                    for (int x = -reach; x <= reach; x++)
                    {
                        double t = ratio * ratio - (x * x + y * y + z * z);
                        sum += t > 0.0 ? t * t * t : 0.0;
                    }
                }
            }

            return sum * Poly6Factor(ratio);
        }
    }
}
