using System;
using System.Collections.Generic;

namespace SphFluid.Tests
{
    /// <summary>
    /// Whether a point that goes straight crosses a triangle whose corners go straight: the times at which the four are in a plane are
    /// the roots of a cubic. In double; shares nothing with the kernels' separating planes.
    /// </summary>
    internal static class MovingTriangle
    {
        public static bool Crosses(Double3 x0, Double3 x1, Double3[] start, Double3[] end)
        {
            if (AreApart(x0, x1, start, end)) return false;
            double Volume(double t)
            {
                Double3 a = At(start[0], end[0], t);
                return Double3.Dot(At(x0, x1, t) - a, Double3.Cross(At(start[1], end[1], t) - a, At(start[2], end[2], t) - a));
            }
            List<double> times = Splits(Volume(-1.0), Volume(0.0), Volume(1.0), Volume(2.0));
            for (int i = 0; i + 1 < times.Count; i++)
            {
                double low = times[i], high = times[i + 1], sign = Volume(low);
                if (sign == 0.0 && IsWithin(x0, x1, start, end, low)) return true;
                if (sign < 0.0 == Volume(high) < 0.0) continue;
                for (int k = 0; k < 60; k++)
                {
                    double middle = 0.5 * (low + high);
                    if (Volume(middle) < 0.0 == sign < 0.0) low = middle;
                    else high = middle;
                }
                if (IsWithin(x0, x1, start, end, 0.5 * (low + high))) return true;
            }
            return false;
        }

        // 0, 1 and the extrema of the cubic through four of its values in between.
        private static List<double> Splits(double before, double f0, double f1, double f2)
        {
            double c3 = (f2 - 3.0 * f1 + 3.0 * f0 - before) / 6.0, c2 = 0.5 * (f1 + before) - f0, c1 = f1 - f0 - c2 - c3;
            var times = new List<double> { 0.0, 1.0 };
            double a = 3.0 * c3, b = 2.0 * c2, square = b * b - 4.0 * a * c1;
            void Add(double t)
            {
                if (t > 0.0 && t < 1.0) times.Add(t);
            }
            if (square >= 0.0)
            {
                double q = -0.5 * (b + (b < 0.0 ? -1.0 : 1.0) * Math.Sqrt(square));
                if (a != 0.0) Add(q / a);
                if (q != 0.0) Add(c1 / q);
            }
            times.Sort();
            return times;
        }

        private static bool IsWithin(Double3 x0, Double3 x1, Double3[] start, Double3[] end, double t)
        {
            Double3 x = At(x0, x1, t), a = At(start[0], end[0], t), b = At(start[1], end[1], t), c = At(start[2], end[2], t);
            Double3 n = Double3.Cross(b - a, c - a);
            return Double3.Dot(n, n) > 0.0 && Double3.Dot(Double3.Cross(c - b, x - b), n) >= 0.0 &&
                Double3.Dot(Double3.Cross(a - c, x - c), n) >= 0.0 && Double3.Dot(Double3.Cross(b - a, x - a), n) >= 0.0;
        }

        private static bool AreApart(Double3 x0, Double3 x1, Double3[] s, Double3[] e) =>
            AreApart(x0.X, x1.X, s[0].X, s[1].X, s[2].X, e[0].X, e[1].X, e[2].X) ||
            AreApart(x0.Y, x1.Y, s[0].Y, s[1].Y, s[2].Y, e[0].Y, e[1].Y, e[2].Y) ||
            AreApart(x0.Z, x1.Z, s[0].Z, s[1].Z, s[2].Z, e[0].Z, e[1].Z, e[2].Z);

        private static bool AreApart(double x0, double x1, double a0, double b0, double c0, double a1, double b1, double c1) =>
            Math.Max(x0, x1) < Math.Min(Math.Min(a0, Math.Min(b0, c0)), Math.Min(a1, Math.Min(b1, c1))) ||
            Math.Min(x0, x1) > Math.Max(Math.Max(a0, Math.Max(b0, c0)), Math.Max(a1, Math.Max(b1, c1)));

        private static Double3 At(Double3 a, Double3 b, double t) => (1.0 - t) * a + t * b;
    }
}
