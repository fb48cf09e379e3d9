using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A point in world space in double precision: at 100 km from the origin a float is good for 8 mm.</summary>
    internal readonly struct WorldPoint
    {
        public WorldPoint(double x, double y, double z) => (X, Y, Z) = (x, y, z);

        /// <summary>A point of the simulation's space, turned and moved to world space.</summary>
        public WorldPoint(in Matrix4x4 localToWorld, Vector3 local)
        {
            X = Along(localToWorld.GetRow(0), local);
            Y = Along(localToWorld.GetRow(1), local);
            Z = Along(localToWorld.GetRow(2), local);
        }

        /// <summary>[m].</summary>
        public double X { get; }

        /// <summary>[m].</summary>
        public double Y { get; }

        /// <summary>[m].</summary>
        public double Z { get; }

        private static double Along(Vector4 row, Vector3 local) => (double)row.x * local.x + (double)row.y * local.y +
            (double)row.z * local.z + row.w;
    }
}
