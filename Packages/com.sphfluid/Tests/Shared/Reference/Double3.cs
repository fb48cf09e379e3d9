using System;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Three doubles: the references compute in double precision and share no code with the GPU side.</summary>
    public readonly struct Double3
    {
        public readonly double X;
        public readonly double Y;
        public readonly double Z;

        public Double3(double x, double y, double z)
        {
            X = x;
            Y = y;
            Z = z;
        }

        public static Double3 Zero => new Double3(0.0, 0.0, 0.0);

        public double this[int axis] => axis == 0 ? X : axis == 1 ? Y : Z;

        public double Length => Math.Sqrt(Dot(this, this));

        public static implicit operator Double3(Vector3 v) => new Double3(v.x, v.y, v.z);

        public static Double3 operator +(Double3 a, Double3 b) => new Double3(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

        public static Double3 operator -(Double3 a, Double3 b) => new Double3(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

        public static Double3 operator -(Double3 a) => new Double3(-a.X, -a.Y, -a.Z);

        public static Double3 operator *(double s, Double3 a) => new Double3(s * a.X, s * a.Y, s * a.Z);

        public static Double3 operator /(Double3 a, double s) => new Double3(a.X / s, a.Y / s, a.Z / s);

        public static double Dot(Double3 a, Double3 b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

        public static Double3 Cross(Double3 a, Double3 b) =>
            new Double3(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);

        public override string ToString() => $"({X:G9}, {Y:G9}, {Z:G9})";
    }
}
