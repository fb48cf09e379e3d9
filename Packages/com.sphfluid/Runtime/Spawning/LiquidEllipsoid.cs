using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>An ellipsoid of liquid: any affine image of a ball.</summary>
    internal sealed class LiquidEllipsoid : LiquidShape
    {
        private readonly Matrix4x4 toUnit;

        /// <summary>Image of the ball of radius ½ round the origin.</summary>
        /// <param name="name">Name for messages.</param>
        /// <param name="unitToSimulation">Maps the ball's space to simulation space [m].</param>
        /// <param name="velocity">Initial velocity in simulation space [m/s].</param>
        public LiquidEllipsoid(string name, Matrix4x4 unitToSimulation, Vector3 velocity) : base(name, unitToSimulation, velocity)
        {
            AffineMath.TryInvert(unitToSimulation, out toUnit);
        }

        /// <inheritdoc/>
        public override double Volume => Math.PI / 6.0 * Math.Abs(AffineMath.Determinant(Frame));

        /// <inheritdoc/>
        public override bool Contains(Vector3 point) => toUnit.MultiplyPoint3x4(point).sqrMagnitude <= 0.25f;
    }
}
