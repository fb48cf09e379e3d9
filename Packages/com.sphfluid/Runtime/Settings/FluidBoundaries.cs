using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What the six faces of the domain box do to the liquid. The default is six frictionless walls at rest.</summary>
    [Serializable]
    public struct FluidBoundaries : IEquatable<FluidBoundaries>
    {
        /// <summary>
        /// Axes along which liquid that leaves one face comes in at the other, and feels what is there. Such faces are no walls.
        /// </summary>
        [Tooltip("Axes along which liquid that leaves one face comes in at the other. A change starts the liquid again.")]
        public FluidAxes Periodic;

        /// <summary>
        /// Faces through which liquid leaves: particles beyond one are removed and counted. No wall is there. Methods Standard and Robust.
        /// </summary>
        [Tooltip(
            "Faces through which liquid leaves the domain: particles beyond one are removed and counted. Methods Standard and Robust.")]
        public FluidFaces Open;

        /// <summary>
        /// Share of the liquid's own viscous stress, τ = µ (v − v_wall)/distance, by which walls drag the layer next to them: 1 holds it
        /// (no slip), 0 only pushes (free slip), as the thesis's walls do. Colliders have the same friction, unless a
        /// <see cref="FluidCollider"/> says otherwise.
        /// </summary>
        [Range(0f, 1f),
            Tooltip(
                "How much walls and colliders hold the liquid next to them: 0 lets it slip freely, 1 holds it by its own viscosity (no " +
                "slip).")]
        public float Friction;

        /// <summary>Whether <see cref="Friction"/> is 1; setting it gives 1 or 0.</summary>
        public bool NoSlip
        {
            readonly get => Friction == 1f;
            set => Friction = value ? 1f : 0f;
        }

        /// <summary>Velocity of the wall at the low face of x [m/s], within its plane. Needs <see cref="Friction"/>.</summary>
        [Tooltip("Velocity of the wall at the low face of x in m/s, within its plane: a moving belt. Needs Friction.")]
        public Vector3 LowX;

        /// <summary>Velocity of the wall at the low face of y [m/s], within its plane. Needs <see cref="Friction"/>.</summary>
        [Tooltip("Velocity of the wall at the low face of y in m/s, within its plane: a moving belt. Needs Friction.")]
        public Vector3 LowY;

        /// <summary>Velocity of the wall at the low face of z [m/s], within its plane. Needs <see cref="Friction"/>.</summary>
        [Tooltip("Velocity of the wall at the low face of z in m/s, within its plane: a moving belt. Needs Friction.")]
        public Vector3 LowZ;

        /// <summary>Velocity of the wall at the high face of x [m/s], within its plane. Needs <see cref="Friction"/>.</summary>
        [Tooltip("Velocity of the wall at the high face of x in m/s, within its plane: a moving belt. Needs Friction.")]
        public Vector3 HighX;

        /// <summary>Velocity of the wall at the high face of y [m/s], within its plane. Needs <see cref="Friction"/>.</summary>
        [Tooltip("Velocity of the wall at the high face of y in m/s, within its plane: a moving belt. Needs Friction.")]
        public Vector3 HighY;

        /// <summary>Velocity of the wall at the high face of z [m/s], within its plane. Needs <see cref="Friction"/>.</summary>
        [Tooltip("Velocity of the wall at the high face of z in m/s, within its plane: a moving belt. Needs Friction.")]
        public Vector3 HighZ;

        /// <summary>Whether all is as without this setting.</summary>
        public bool IsDefault => Equals(default);

        /// <summary>The same of a domain that is open on every side.</summary>
        internal readonly FluidBoundaries WithAllOpen()
        {
            FluidBoundaries open = this;
            open.Open = FluidFaces.All;
            return open;
        }

        /// <summary>Faces that are walls: neither open nor periodic.</summary>
        internal FluidFaces Walls => FluidFaces.All & ~(Open | FacesOf(Periodic));

        /// <summary>Checks that every face can be computed with.</summary>
        /// <exception cref="ArgumentException">A velocity is out of range or acts on nothing; the message names it and the
        /// cure.</exception>
        internal void Validate()
        {
            if ((Periodic & ~FluidAxes.All) != 0)
            {
                throw new ArgumentException($"Boundaries.Periodic is {(int)Periodic}; it must be a sum of X = 1, Y = 2 and Z = 4.");
            }

            CheckOpen();
            if (!(Friction >= 0f && Friction <= 1f))
            {
                throw new ArgumentException($"Boundaries.Friction is {Friction}; it must be from 0 (free slip) to 1 (no slip).");
            }

            CheckWall(LowX, FluidFaces.LowX, FluidAxes.X, LowX.x);
            CheckWall(LowY, FluidFaces.LowY, FluidAxes.Y, LowY.y);
            CheckWall(LowZ, FluidFaces.LowZ, FluidAxes.Z, LowZ.z);
            CheckWall(HighX, FluidFaces.HighX, FluidAxes.X, HighX.x);
            CheckWall(HighY, FluidFaces.HighY, FluidAxes.Y, HighY.y);
            CheckWall(HighZ, FluidFaces.HighZ, FluidAxes.Z, HighZ.z);
        }

        /// <inheritdoc/>
        public bool Equals(FluidBoundaries other) => Periodic == other.Periodic && Open == other.Open && Friction.Equals(other.Friction) &&
            AffineMath.Same(LowX, other.LowX) && AffineMath.Same(LowY, other.LowY) && AffineMath.Same(LowZ, other.LowZ) &&
            AffineMath.Same(HighX, other.HighX) && AffineMath.Same(HighY, other.HighY) && AffineMath.Same(HighZ, other.HighZ);

        /// <inheritdoc/>
        public override bool Equals(object obj) => obj is FluidBoundaries other && Equals(other);

        /// <inheritdoc/>
        public override int GetHashCode() => HashCode.Combine((Periodic, Open), Friction, LowX, LowY, LowZ, HighX, HighY, HighZ);

        /// <summary>Both faces of each axis.</summary>
        internal static FluidFaces FacesOf(FluidAxes axes) =>
            ((axes & FluidAxes.X) != 0 ? FluidFaces.LowX | FluidFaces.HighX : FluidFaces.None) |
            ((axes & FluidAxes.Y) != 0 ? FluidFaces.LowY | FluidFaces.HighY : FluidFaces.None) |
            ((axes & FluidAxes.Z) != 0 ? FluidFaces.LowZ | FluidFaces.HighZ : FluidFaces.None);

        private void CheckOpen()
        {
            if ((Open & ~FluidFaces.All) != 0)
            {
                throw new ArgumentException(
                    $"Boundaries.Open is {(int)Open}; it must be a sum of LowX = 1, HighX = 2, LowY = 4, HighY = 8, LowZ = 16 and HighZ " +
                    "= 32.");
            }

            FluidFaces both = Open & FacesOf(Periodic);
            if (both != FluidFaces.None)
            {
                throw new ArgumentException(
                    $"Boundaries.Open has {both}, but Boundaries.Periodic has {Periodic}, whose faces lead into each other. Take the " +
                    "face out of one of both.");
            }
        }

        private void CheckWall(Vector3 velocity, FluidFaces name, FluidAxes axis, float across)
        {
            if (!(velocity.sqrMagnitude < float.PositiveInfinity))
            {
                throw new ArgumentException($"The wall velocity Boundaries.{name} is {velocity} m/s; it must be finite numbers.");
            }

            if (velocity == Vector3.zero) return;

            if (across != 0f)
            {
                throw new ArgumentException(
                    $"The wall velocity Boundaries.{name} is {velocity} m/s; it must lie in the wall's plane. Set its {axis} component " +
                    "to zero.");
            }

            if ((Periodic & axis) != 0)
            {
                throw new ArgumentException(
                    $"The wall velocity Boundaries.{name} is {velocity} m/s, but {axis} is periodic and has no walls. Set the velocity " +
                    "to zero, or " +
                    $"take {axis} out of Boundaries.Periodic.");
            }

            if ((Open & name) != 0)
            {
                throw new ArgumentException(
                    $"The wall velocity Boundaries.{name} is {velocity} m/s, but that face is open and has no wall. Set the velocity to " +
                    "zero, or " +
                    $"take {name} out of Boundaries.Open.");
            }

            if (!(Friction > 0f))
            {
                throw new ArgumentException(
                    $"The wall velocity Boundaries.{name} is {velocity} m/s, but walls without friction only push. Set " +
                    "Boundaries.Friction, or the velocity to zero.");
            }
        }
    }
}
