using System;
using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid
{
    /// <summary>An acceleration in a part of the domain, as Shaders/Solver/ForceZones.hlsl reads it; all in simulation space, SI.</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct ForceZone : IEquatable<ForceZone>
    {
        /// <summary>Bytes on the GPU.</summary>
        public const int Stride = 9 * 16;

        /// <summary>Most zones of a liquid.</summary>
        public const int Most = 16;

        private Vector4 rowX, rowY, rowZ;

        /// <summary>Half extents of a box, and the radius that rounds it [m]: a sphere has no box, a capsule a line.</summary>
        public Vector4 Core;

        /// <summary>Acceleration [m/s²]; the fourth is for <see cref="ForceZones"/>.</summary>
        public Vector4 Uniform;

        /// <summary>A point [m], and the acceleration towards it [m/s²].</summary>
        public Vector4 Centre;

        /// <summary>A unit vector, and the acceleration around it [m/s²].</summary>
        public Vector4 Axis;

        /// <summary>A velocity [m/s], and the rate of drag towards it [1/s].</summary>
        public Vector4 Wind;

        /// <summary>
        /// Of eddies: the largest acceleration along an axis [m/s²], 2π over their size [1/m], a phase that changes them, and over how much
        /// this zone comes to its full strength [m]; 0: as all zones do.
        /// </summary>
        public Vector4 Eddies;

        /// <summary>Where the zone is.</summary>
        /// <param name="position">Its centre [m].</param>
        /// <param name="rotation">Its axes.</param>
        public void Place(Vector3 position, Quaternion rotation)
        {
            Matrix4x4 toZone = DomainSpace.FromWorld(position, rotation);
            (rowX, rowY, rowZ) = (toZone.GetRow(0), toZone.GetRow(1), toZone.GetRow(2));
            Centre = new Vector4(position.x, position.y, position.z, Centre.w);
        }

        /// <summary>A box around it [m].</summary>
        public readonly Bounds Bounds => new Bounds(Centre, 2f * (((Vector3)Core).magnitude + Core.w) * Vector3.one);

        public readonly bool Equals(ForceZone other) => rowX.Equals(other.rowX) && rowY.Equals(other.rowY) && rowZ.Equals(other.rowZ) &&
            Core.Equals(other.Core) &&
            Uniform.Equals(other.Uniform) && Centre.Equals(other.Centre) && Axis.Equals(other.Axis) && Wind.Equals(other.Wind) &&
            Eddies.Equals(other.Eddies);

        public readonly override bool Equals(object obj) => obj is ForceZone other && Equals(other);

        public readonly override int GetHashCode() => HashCode.Combine(rowX, rowY, rowZ, Core, Uniform, Centre, Axis, Wind);
    }
}
