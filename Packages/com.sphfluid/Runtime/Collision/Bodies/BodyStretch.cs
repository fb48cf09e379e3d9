using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The stretch of a body as the GPU has it: a symmetric, positive definite matrix.</summary>
    internal readonly struct BodyStretch : IEquatable<BodyStretch>
    {
        // Unity's matrices are rounded: what differs by no more is the same stretch. It is compared with the last one in use, so
        // that a slow change adds up and is followed; 1e-5 of a body of 10 m is 0.1 mm.
        private const float Tolerance = 1e-5f;

        private BodyStretch(Vector3 diagonal, Vector3 shear)
        {
            Diagonal = diagonal;
            Shear = shear;
        }

        /// <summary>xx, yy, zz.</summary>
        public Vector3 Diagonal { get; }

        /// <summary>yz, zx, xy.</summary>
        public Vector3 Shear { get; }

        public static BodyStretch None => new BodyStretch(Vector3.one, Vector3.zero);

        public bool IsNone => Equals(None);

        public AffineMap Map => new AffineMap(Diagonal.x, Shear.z, Shear.y, Shear.z, Diagonal.y, Shear.x, Shear.y, Shear.x, Diagonal.z);

        /// <summary>The stretch of a decomposition, or the last one where they differ by rounding alone.</summary>
        public static BodyStretch Create(in AffineMap stretch, BodyStretch last)
        {
            var found = new BodyStretch(new Vector3((float)stretch.M00, (float)stretch.M11, (float)stretch.M22),
                new Vector3((float)stretch.M12, (float)stretch.M02, (float)stretch.M01));
            bool same = Largest(found.Diagonal - last.Diagonal) < Tolerance && Largest(found.Shear - last.Shear) < Tolerance;
            return same ? last : found;
        }

        /// <summary>Smallest and largest eigenvalue.</summary>
        public (double least, double most) Range()
        {
            // O. K. Smith, Eigenvalues of a Symmetric 3 × 3 Matrix, 1961.
            double off = (double)Shear.x * Shear.x + (double)Shear.y * Shear.y + (double)Shear.z * Shear.z;
            double mean = ((double)Diagonal.x + Diagonal.y + Diagonal.z) / 3.0;
            double a = Diagonal.x - mean, b = Diagonal.y - mean, c = Diagonal.z - mean;
            double p = Math.Sqrt((a * a + b * b + c * c + 2.0 * off) / 6.0);
            if (p < 1e-12 * mean) return (mean, mean);
            double determinant = a * (b * c - (double)Shear.x * Shear.x) - Shear.z * (Shear.z * c - (double)Shear.x * Shear.y) +
                Shear.y * ((double)Shear.z * Shear.x - b * Shear.y);
            double angle = Math.Acos(Math.Max(-1.0, Math.Min(1.0, determinant / (2.0 * p * p * p)))) / 3.0;
            return (mean + 2.0 * p * Math.Cos(angle + 2.0 * Math.PI / 3.0), mean + 2.0 * p * Math.Cos(angle));
        }

        /// <summary>Frobenius's norm of the difference, no less than its largest eigenvalue.</summary>
        public static double Change(BodyStretch a, BodyStretch b)
        {
            Vector3 diagonal = b.Diagonal - a.Diagonal, shear = b.Shear - a.Shear;
            return Math.Sqrt(diagonal.sqrMagnitude + 2.0 * shear.sqrMagnitude);
        }

        public bool Equals(BodyStretch other) => AffineMath.Same(Diagonal, other.Diagonal) && AffineMath.Same(Shear, other.Shear);

        public override bool Equals(object obj) => obj is BodyStretch other && Equals(other);

        public override int GetHashCode() => HashCode.Combine(Diagonal, Shear);

        private static float Largest(Vector3 v) => Mathf.Max(Mathf.Abs(v.x), Mathf.Max(Mathf.Abs(v.y), Mathf.Abs(v.z)));
    }
}
