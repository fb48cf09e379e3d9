using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Fits a box of liquid to the domain's walls. Liquid that ends a spacing or less from a wall would fall against it at the start, and
    /// throw up what it meets there.
    /// </summary>
    internal static class WallFit
    {
        private const float Tolerance = 1e-3f; // of a spacing
        private const float MostDrawnOut = 1f / 3f; // of the box: what is thinner than three gaps is a drop, and no pool

        /// <summary>A box with faces along the domain's axes, drawn out to the walls that it ends a spacing or less from.</summary>
        /// <param name="box">The box in simulation space [m].</param>
        /// <param name="domain">Edge lengths of the domain [m].</param>
        /// <param name="walls">Faces of the domain that are walls.</param>
        /// <param name="spacing">Particle spacing [m].</param>
        /// <param name="gravity">Gravity [m/s²]: liquid is not drawn up to a ceiling.</param>
        public static Bounds DrawnOut(Bounds box, Vector3 domain, FluidFaces walls, float spacing, Vector3 gravity)
        {
            Vector3 low = box.min, high = box.max;
            float steep = 0.5f * gravity.magnitude;
            for (int axis = 0; axis < 3; axis++)
            {
                float wall = 0.5f * domain[axis];
                float near = Mathf.Min((1f + Tolerance) * spacing, MostDrawnOut * box.size[axis]);
                if (IsWall(walls, 2 * axis) && gravity[axis] <= steep && IsNear(low[axis] + wall, near)) low[axis] = -wall;
                if (IsWall(walls, 2 * axis + 1) && gravity[axis] >= -steep && IsNear(wall - high[axis], near)) high[axis] = wall;
            }
            if (low != box.min || high != box.max) box.SetMinMax(low, high); // which rounds
            return box;
        }

        /// <summary>The walls of the domain at which a box stands.</summary>
        /// <param name="box">The box in simulation space [m].</param>
        /// <param name="domain">Edge lengths of the domain [m].</param>
        /// <param name="walls">Faces of the domain that are walls.</param>
        /// <param name="spacing">Particle spacing [m].</param>
        public static FluidFaces At(Bounds box, Vector3 domain, FluidFaces walls, float spacing)
        {
            var at = (FluidFaces)0;
            for (int face = 0; face < 6; face++)
            {
                int axis = face / 2;
                float gap = 0.5f * domain[axis] + (face % 2 == 0 ? box.min[axis] : -box.max[axis]);
                if (IsWall(walls, face) && Mathf.Abs(gap) <= Tolerance * spacing) at |= (FluidFaces)(1 << face);
            }
            return at;
        }

        private static bool IsWall(FluidFaces walls, int face) => (walls & (FluidFaces)(1 << face)) != 0;

        private static bool IsNear(float gap, float near) => gap > 0f && gap <= near;
    }
}
