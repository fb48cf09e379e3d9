using System;

namespace SphFluid.Validation
{
    /// <summary>Kernels in double precision, written down anew from the papers: no code of the solver's.</summary>
    internal static class CpuKernels
    {
        /// <summary>Factor of poly6, 315/(64πh⁹): Müller et al. (2003), equation 20.</summary>
        public static double Poly6Factor(double h)
        {
            double h3 = h * h * h;
            return 315.0 / (64.0 * Math.PI * h3 * h3 * h3);
        }

        /// <summary>Factor of the spiky kernel's gradient and of the viscosity kernel's Laplacian, 45/(πh⁶): equations 21 and 22.</summary>
        public static double SpikyGradientFactor(double h)
        {
            double h3 = h * h * h;
            return 45.0 / (Math.PI * h3 * h3);
        }

        /// <summary>Wendland's C2 kernel (1995) times R³ at q = r/R: 21/(2π) (1 − q)⁴ (1 + 4q), 0 from q = 1.</summary>
        public static double Wendland(double q) => q < 1.0 ? 21.0 / (2.0 * Math.PI) * Math.Pow(1.0 - q, 4.0) * (1.0 + 4.0 * q) : 0.0;
    }
}
