using UnityEngine;

namespace SphFluid
{
    /// <summary>A box of liquid: any affine image of a cube.</summary>
    internal sealed class LiquidBox : LiquidShape
    {
        /// <summary>Half-width by which a point on a face counts as inside the lower face and outside the upper one.</summary>
        const float FaceTolerance = 1e-4f;

        readonly Matrix4x4 toUnit;

        /// <summary>Box whose corners are the images of (±½, ±½, ±½).</summary>
        /// <param name="name">Name for messages.</param>
        /// <param name="unitToSimulation">Maps the unit cube centred on the origin to simulation space [m].</param>
        /// <param name="velocity">Initial velocity in simulation space [m/s].</param>
        public LiquidBox(string name, Matrix4x4 unitToSimulation, Vector3 velocity) : base(name, unitToSimulation, velocity)
        {
            AffineMath.TryInvert(unitToSimulation, out toUnit);
        }

        /// <inheritdoc/>
        public override double Volume => System.Math.Abs(AffineMath.Determinant(Frame));

        /// <summary>Whether the point lies in the box; of two touching boxes only one holds a point of the shared face.</summary>
        public override bool Contains(Vector3 point)
        {
            Vector3 p = toUnit.MultiplyPoint3x4(point);
            return Inside(p.x) && Inside(p.y) && Inside(p.z);
        }

        static bool Inside(float u) => u >= -0.5f - FaceTolerance && u < 0.5f - FaceTolerance;
    }
}
