using UnityEngine;

namespace SphFluid
{
    /// <summary>A box of liquid in simulation space, as the spawner needs it: any affine image of a cube.</summary>
    internal readonly struct LiquidBox
    {
        /// <summary>Half-width by which a point on a face counts as inside the lower face and outside the upper one.</summary>
        const float FaceTolerance = 1e-4f;

        readonly Matrix4x4 toUnit;

        /// <summary>Box whose corners are the images of (±½, ±½, ±½).</summary>
        /// <param name="name">Name for messages.</param>
        /// <param name="unitToSimulation">Maps the unit cube centred on the origin to simulation space [m].</param>
        /// <param name="velocity">Initial velocity in simulation space [m/s].</param>
        public LiquidBox(string name, Matrix4x4 unitToSimulation, Vector3 velocity)
        {
            Name = name;
            UnitToSimulation = unitToSimulation;
            Velocity = velocity;
            AffineMath.TryInvert(unitToSimulation, out toUnit);
        }

        public string Name { get; }
        public Matrix4x4 UnitToSimulation { get; }
        public Vector3 Velocity { get; }

        /// <summary>Volume [m³].</summary>
        public double Volume => System.Math.Abs(AffineMath.Determinant(UnitToSimulation));

        /// <summary>Axis-aligned bounds in simulation space.</summary>
        public Bounds Bounds
        {
            get
            {
                Vector3 extents = Vector3.zero;
                for (int column = 0; column < 3; column++)
                {
                    Vector4 axis = UnitToSimulation.GetColumn(column);
                    extents += new Vector3(Mathf.Abs(axis.x), Mathf.Abs(axis.y), Mathf.Abs(axis.z)) * 0.5f;
                }
                return new Bounds(UnitToSimulation.GetColumn(3), extents * 2f);
            }
        }

        /// <summary>Whether the point lies in the box; of two touching boxes only one holds a point of the shared face.</summary>
        public bool Contains(Vector3 point)
        {
            Vector3 p = toUnit.MultiplyPoint3x4(point);
            return Inside(p.x) && Inside(p.y) && Inside(p.z);
        }

        static bool Inside(float u) => u >= -0.5f - FaceTolerance && u < 0.5f - FaceTolerance;
    }
}
