using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A symmetric 3 × 3 matrix in double precision.</summary>
    readonly struct SymmetricTensor
    {
        // Far more than the quadratic convergence of cyclic Jacobi needs for three rows.
        const int Sweeps = 8;

        public readonly double Xx, Yy, Zz, Xy, Xz, Yz;

        public SymmetricTensor(double xx, double yy, double zz, double xy, double xz, double yz)
        {
            (Xx, Yy, Zz, Xy, Xz, Yz) = (xx, yy, zz, xy, xz, yz);
        }

        /// <summary>Sum of the eigenvalues.</summary>
        public double Trace => Xx + Yy + Zz;

        /// <summary>This plus weight · v vᵀ.</summary>
        public SymmetricTensor PlusOuter(Vector3 v, double weight) => new SymmetricTensor(
            Xx + weight * v.x * v.x, Yy + weight * v.y * v.y, Zz + weight * v.z * v.z,
            Xy + weight * v.x * v.y, Xz + weight * v.x * v.z, Yz + weight * v.y * v.z);

        /// <summary>This times a number.</summary>
        public SymmetricTensor Times(double factor) =>
            new SymmetricTensor(factor * Xx, factor * Yy, factor * Zz, factor * Xy, factor * Xz, factor * Yz);

        /// <summary>vᵀ M v.</summary>
        public double Form(Vector3 v) =>
            Xx * v.x * v.x + Yy * v.y * v.y + Zz * v.z * v.z + 2.0 * (Xy * (double)v.x * v.y + Xz * (double)v.x * v.z + Yz * (double)v.y * v.z);

        /// <summary>Eigenvalues and unit eigenvectors by cyclic Jacobi rotations, in no order.</summary>
        public void Eigen(double[] values, Vector3[] vectors)
        {
            double[,] a = { { Xx, Xy, Xz }, { Xy, Yy, Yz }, { Xz, Yz, Zz } };
            double[,] q = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
            for (int sweep = 0; sweep < Sweeps; sweep++)
            {
                Rotate(a, q, 0, 1);
                Rotate(a, q, 0, 2);
                Rotate(a, q, 1, 2);
            }
            for (int i = 0; i < 3; i++)
            {
                values[i] = a[i, i];
                vectors[i] = new Vector3((float)q[0, i], (float)q[1, i], (float)q[2, i]);
            }
        }

        // The rotation in the plane of two rows that makes their off-diagonal element zero.
        static void Rotate(double[,] a, double[,] q, int row, int column)
        {
            if (a[row, column] == 0.0)
                return;
            double theta = (a[column, column] - a[row, row]) / (2.0 * a[row, column]);
            double tangent = (theta >= 0.0 ? 1.0 : -1.0) / (Math.Abs(theta) + Math.Sqrt(theta * theta + 1.0));
            double cosine = 1.0 / Math.Sqrt(tangent * tangent + 1.0), sine = tangent * cosine;
            for (int k = 0; k < 3; k++)
                (a[k, row], a[k, column]) = (cosine * a[k, row] - sine * a[k, column], sine * a[k, row] + cosine * a[k, column]);
            for (int k = 0; k < 3; k++)
            {
                (a[row, k], a[column, k]) = (cosine * a[row, k] - sine * a[column, k], sine * a[row, k] + cosine * a[column, k]);
                (q[k, row], q[k, column]) = (cosine * q[k, row] - sine * q[k, column], sine * q[k, row] + cosine * q[k, column]);
            }
        }
    }
}
