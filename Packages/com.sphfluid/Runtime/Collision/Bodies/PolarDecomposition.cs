using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A linear map A as a rotation after a stretch: A = R S with S symmetric and positive definite. Unique where det A &gt; 0.
    /// </summary>
    internal readonly struct PolarDecomposition
    {
        // Newton's steps double the digits; scaled, they need less than ten for any map that double can invert.
        private const int MostSteps = 24;

        private PolarDecomposition(in AffineMap rotation, in AffineMap stretch)
        {
            Rotation = rotation;
            Stretch = stretch;
        }

        /// <summary>R, without an offset.</summary>
        public AffineMap Rotation { get; }

        /// <summary>S, without an offset.</summary>
        public AffineMap Stretch { get; }

        /// <summary>
        /// Takes the linear part of a map apart: R ← (g R + R⁻ᵀ/g)/2 with g = √(|R⁻¹| / |R|) (N. J. Higham, Computing the Polar
        /// Decomposition, 1986).
        /// </summary>
        /// <returns>False where the map mirrors, flattens or is not finite.</returns>
        public static bool TryFind(in AffineMap map, out PolarDecomposition parts)
        {
            parts = default;
            AffineMap a = map.At(0.0, 0.0, 0.0), r = a;
            double size = Norm(a);
            if (!(size > 0.0) || double.IsInfinity(size) || !(a.Determinant > 1e-12 * size * size * size)) return false;
            for (int step = 0; step < MostSteps; step++)
            {
                AffineMap inverse = r.Inverse.Transpose;
                double scale = Math.Sqrt(Norm(inverse) / Norm(r));
                AffineMap next = r.Mixed(0.5 * scale, inverse, 0.5 / scale);
                double change = AffineMap.Difference(next, r);
                r = next;
                if (change < 1e-15) break;
            }
            AffineMap s = r.Transpose * a;
            parts = new PolarDecomposition(r, s.Mixed(0.5, s.Transpose, 0.5));
            return true;
        }

        /// <summary>The rotation as a unit quaternion (S. W. Shepperd, Quaternion from Rotation Matrix, 1978).</summary>
        public Quaternion Quaternion
        {
            get
            {
                AffineMap m = Rotation;
                double trace = m.M00 + m.M11 + m.M22;
                double largest = Math.Max(Math.Max(trace, m.M00), Math.Max(m.M11, m.M22));
                double x, y, z, w;
                if (largest == trace) (x, y, z, w) = (m.M21 - m.M12, m.M02 - m.M20, m.M10 - m.M01, 1.0 + trace);
                else if (largest == m.M00) (x, y, z, w) = (1.0 + 2.0 * m.M00 - trace, m.M01 + m.M10, m.M02 + m.M20, m.M21 - m.M12);
                else if (largest == m.M11) (x, y, z, w) = (m.M01 + m.M10, 1.0 + 2.0 * m.M11 - trace, m.M12 + m.M21, m.M02 - m.M20);
                else (x, y, z, w) = (m.M02 + m.M20, m.M12 + m.M21, 1.0 + 2.0 * m.M22 - trace, m.M10 - m.M01);
                double scale = 1.0 / Math.Sqrt(x * x + y * y + z * z + w * w);
                return new Quaternion((float)(x * scale), (float)(y * scale), (float)(z * scale), (float)(w * scale));
            }
        }

        // Frobenius's.
        private static double Norm(in AffineMap m) => Math.Sqrt(
            m.M00 * m.M00 + m.M01 * m.M01 + m.M02 * m.M02 + m.M10 * m.M10 + m.M11 * m.M11 + m.M12 * m.M12 + m.M20 * m.M20 + m.M21 * m.M21 +
                m.M22 * m.M22);
    }
}
