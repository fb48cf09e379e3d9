using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>A force per mass that depends on the position: a = −ω² (x − centre), an axis each. Zero rates: none.</summary>
    [Serializable]
    public struct FluidBodyForce : IEquatable<FluidBodyForce>
    {
        /// <summary>Where the force is zero [m], simulation space.</summary>
        [Tooltip("Where the force is zero, in metres from the centre of the domain box.")]
        public Vector3 Centre;

        /// <summary>ω² along each axis [1/s²]; negative ones push away.</summary>
        [Tooltip("Acceleration per metre of distance from the centre in 1/s², towards it. Zero: no force.")]
        public Vector3 RateSquared;

        /// <summary>Whether there is a force.</summary>
        public bool IsOn => RateSquared != Vector3.zero;

        /// <summary>Checks that the force can be computed.</summary>
        /// <param name="periodic">Axes without walls, along which there is no one distance from the centre.</param>
        /// <exception cref="ArgumentException">A number is not finite, or the force acts along a periodic axis.</exception>
        internal void Validate(FluidAxes periodic)
        {
            if (!(Centre.sqrMagnitude < float.PositiveInfinity) || !(RateSquared.sqrMagnitude < float.PositiveInfinity))
            {
                throw new ArgumentException(
                    $"The body force has the centre {Centre} m and RateSquared {RateSquared} 1/s²; all must be finite numbers.");
            }

            CheckAxis(periodic, FluidAxes.X, RateSquared.x);
            CheckAxis(periodic, FluidAxes.Y, RateSquared.y);
            CheckAxis(periodic, FluidAxes.Z, RateSquared.z);
        }

        /// <inheritdoc/>
        public bool Equals(FluidBodyForce other) => AffineMath.Same(Centre, other.Centre) &&
            AffineMath.Same(RateSquared, other.RateSquared);

        /// <inheritdoc/>
        public override bool Equals(object obj) => obj is FluidBodyForce other && Equals(other);

        /// <inheritdoc/>
        public override int GetHashCode() => HashCode.Combine(Centre, RateSquared);

        private static void CheckAxis(FluidAxes periodic, FluidAxes axis, float rate)
        {
            if ((periodic & axis) != 0 && rate != 0f)
            {
                throw new ArgumentException(
                    $"The body force's RateSquared is {rate} 1/s² along {axis}, which is periodic: there a particle has no one distance " +
                    "from the centre. " +
                    $"Set it to zero, or take {axis} out of Boundaries.Periodic.");
            }
        }
    }
}
