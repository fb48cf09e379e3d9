using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Three numbers of double precision, for sums over many particles.</summary>
    readonly struct Vector3d
    {
        public readonly double X, Y, Z;

        public Vector3d(double x, double y, double z)
        {
            X = x;
            Y = y;
            Z = z;
        }

        public Vector3d(Vector3 v) : this(v.x, v.y, v.z)
        {
        }

        public double Length => Math.Sqrt(Dot(this));

        public double Dot(Vector3d other) => X * other.X + Y * other.Y + Z * other.Z;

        public static Vector3d operator +(Vector3d a, Vector3d b) => new Vector3d(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

        public static Vector3d operator -(Vector3d a, Vector3d b) => new Vector3d(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

        public static Vector3d operator *(double s, Vector3d a) => new Vector3d(s * a.X, s * a.Y, s * a.Z);
    }
}
