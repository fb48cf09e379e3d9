using System;

namespace SphFluid.Validation
{
    /// <summary>
    /// Flows that start from rest between two plane walls without slip, at y = 0 and y = L: the series solutions of
    /// u_t = ν u_yy + F (Morris, Fox and Zhu, J. Comput. Phys. 136, 1997, equations 21 and 23).
    /// </summary>
    public static class ChannelFlow
    {
        /// <summary>Walls at rest, a force per mass F along them; in the end the parabola F y (L − y)/2ν.</summary>
        /// <param name="y">Distance from the lower wall [m].</param>
        /// <param name="t">Time since the start [s].</param>
        /// <param name="gap">L [m].</param>
        /// <param name="viscosity">ν [m²/s].</param>
        /// <param name="force">F [m/s²].</param>
        /// <returns>u [m/s].</returns>
        public static double Poiseuille(double y, double t, double gap, double viscosity, double force)
        {
            if (t <= 0.0) return 0.0;
            double u = 0.5 * force * y * (gap - y) / viscosity;
            double scale = 4.0 * force * gap * gap / (viscosity * Math.PI * Math.PI * Math.PI);
            int terms = Terms(t, gap, viscosity);
            for (int n = 1; n <= terms; n += 2)
            {
                u -= scale / ((double)n * n * n) * Math.Sin(n * Math.PI * y / gap) * Decay(n, t, gap, viscosity);
            }
            return u;
        }

        /// <summary>Lower wall at rest, upper wall moving at V from t = 0 on; in the end the straight line V y/L.</summary>
        /// <param name="y">Distance from the lower wall [m].</param>
        /// <param name="t">Time since the start [s].</param>
        /// <param name="gap">L [m].</param>
        /// <param name="viscosity">ν [m²/s].</param>
        /// <param name="speed">V [m/s].</param>
        /// <returns>u [m/s].</returns>
        public static double Couette(double y, double t, double gap, double viscosity, double speed)
        {
            if (t <= 0.0) return y < gap ? 0.0 : speed;
            double u = speed * y / gap;
            int terms = Terms(t, gap, viscosity);
            for (int n = 1; n <= terms; n++)
            {
                double sign = n % 2 == 0 ? 1.0 : -1.0;
                u += 2.0 * speed * sign / (n * Math.PI) * Math.Sin(n * Math.PI * y / gap) * Decay(n, t, gap, viscosity);
            }
            return u;
        }

        private static double Decay(int n, double t, double gap, double viscosity) =>
            Math.Exp(-n * (double)n * Math.PI * Math.PI * viscosity * t / (gap * gap));

        // The terms beyond are below e^-40 of the first.
        private static int Terms(double t, double gap, double viscosity) =>
            (int)Math.Min(1e5, 2.0 + Math.Sqrt(40.0 / (Math.PI * Math.PI * viscosity * t)) * gap);
    }
}
