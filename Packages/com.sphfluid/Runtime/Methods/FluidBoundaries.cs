using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What the six faces of the domain box do to the liquid. The default is six walls at rest that push but do not rub.</summary>
    [Serializable]
    public struct FluidBoundaries : IEquatable<FluidBoundaries>
    {
        /// <summary>Axes along which liquid that leaves one face comes in at the other, and feels what is there. Such faces are no walls.</summary>
        [Tooltip("Axes along which liquid that leaves one face comes in at the other. A change starts the liquid again.")]
        public FluidAxes Periodic;

        /// <summary>
        /// True: a wall drags the layer next to it by the liquid's own viscous stress, τ = µ (v − v_wall)/distance.
        /// False: walls only push, as the thesis's do.
        /// </summary>
        [Tooltip("Walls drag the liquid next to them by its own viscosity (no slip). Off: walls only push, as in the thesis.")]
        public bool NoSlip;

        /// <summary>Velocity of the wall at the low face of x [m/s], within its plane. Needs <see cref="NoSlip"/>.</summary>
        [Tooltip("Velocity of the wall at the low face of x in m/s, within its plane: a moving belt. Needs No Slip.")]
        public Vector3 LowX;

        /// <summary>Velocity of the wall at the low face of y [m/s], within its plane. Needs <see cref="NoSlip"/>.</summary>
        [Tooltip("Velocity of the wall at the low face of y in m/s, within its plane: a moving belt. Needs No Slip.")]
        public Vector3 LowY;

        /// <summary>Velocity of the wall at the low face of z [m/s], within its plane. Needs <see cref="NoSlip"/>.</summary>
        [Tooltip("Velocity of the wall at the low face of z in m/s, within its plane: a moving belt. Needs No Slip.")]
        public Vector3 LowZ;

        /// <summary>Velocity of the wall at the high face of x [m/s], within its plane. Needs <see cref="NoSlip"/>.</summary>
        [Tooltip("Velocity of the wall at the high face of x in m/s, within its plane: a moving belt. Needs No Slip.")]
        public Vector3 HighX;

        /// <summary>Velocity of the wall at the high face of y [m/s], within its plane. Needs <see cref="NoSlip"/>.</summary>
        [Tooltip("Velocity of the wall at the high face of y in m/s, within its plane: a moving belt. Needs No Slip.")]
        public Vector3 HighY;

        /// <summary>Velocity of the wall at the high face of z [m/s], within its plane. Needs <see cref="NoSlip"/>.</summary>
        [Tooltip("Velocity of the wall at the high face of z in m/s, within its plane: a moving belt. Needs No Slip.")]
        public Vector3 HighZ;

        /// <summary>Whether all is as without this setting.</summary>
        public bool IsDefault => Equals(default);

        /// <summary>Checks that every face can be computed with.</summary>
        /// <exception cref="ArgumentException">A velocity is out of range or acts on nothing; the message names it and the cure.</exception>
        internal void Validate()
        {
            if ((Periodic & ~FluidAxes.All) != 0)
            {
                throw new ArgumentException($"Boundaries.Periodic is {(int)Periodic}; it must be a sum of X = 1, Y = 2 and Z = 4.");
            }

            CheckWall(LowX, nameof(LowX), FluidAxes.X, LowX.x);
            CheckWall(LowY, nameof(LowY), FluidAxes.Y, LowY.y);
            CheckWall(LowZ, nameof(LowZ), FluidAxes.Z, LowZ.z);
            CheckWall(HighX, nameof(HighX), FluidAxes.X, HighX.x);
            CheckWall(HighY, nameof(HighY), FluidAxes.Y, HighY.y);
            CheckWall(HighZ, nameof(HighZ), FluidAxes.Z, HighZ.z);
        }

        /// <inheritdoc/>
        public bool Equals(FluidBoundaries other) => Periodic == other.Periodic && NoSlip == other.NoSlip &&
            AffineMath.Same(LowX, other.LowX) && AffineMath.Same(LowY, other.LowY) && AffineMath.Same(LowZ, other.LowZ) &&
            AffineMath.Same(HighX, other.HighX) && AffineMath.Same(HighY, other.HighY) && AffineMath.Same(HighZ, other.HighZ);

        /// <inheritdoc/>
        public override bool Equals(object obj) => obj is FluidBoundaries other && Equals(other);

        /// <inheritdoc/>
        public override int GetHashCode() => HashCode.Combine(Periodic, NoSlip, LowX, LowY, LowZ, HighX, HighY, HighZ);

        void CheckWall(Vector3 velocity, string name, FluidAxes axis, float across)
        {
            if (!(velocity.sqrMagnitude < float.PositiveInfinity))
            {
                throw new ArgumentException($"The wall velocity Boundaries.{name} is {velocity} m/s; it must be finite numbers.");
            }

            if (velocity == Vector3.zero)
            {
                return;
            }

            if (across != 0f)
            {
                throw new ArgumentException(
                    $"The wall velocity Boundaries.{name} is {velocity} m/s; it must lie in the wall's plane. Set its {axis} component to zero.");
            }

            if ((Periodic & axis) != 0)
            {
                throw new ArgumentException(
                    $"The wall velocity Boundaries.{name} is {velocity} m/s, but {axis} is periodic and has no walls. Set the velocity to zero, or " +
                    $"take {axis} out of Boundaries.Periodic.");
            }

            if (!NoSlip)
            {
                throw new ArgumentException(
                    $"The wall velocity Boundaries.{name} is {velocity} m/s, but walls without NoSlip only push. Set NoSlip, or the velocity to zero.");
            }
        }
    }
}
