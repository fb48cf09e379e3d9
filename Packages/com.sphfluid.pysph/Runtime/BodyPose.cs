using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Where a body is at a time: a row of its path.</summary>
    [StructLayout(LayoutKind.Sequential, Pack = 4)]
    internal struct BodyPose
    {
        /// <summary>The columns as NumPy has them.</summary>
        public static readonly string[] Columns = { "t <f8", "x <f4", "y <f4", "z <f4", "qx <f4", "qy <f4", "qz <f4", "qw <f4" };

        /// <summary>Time since the first pose [s].</summary>
        public double Time;

        /// <summary>The pivot [m], simulation space.</summary>
        public Vector3 Position;

        /// <summary>
        /// Turn since the first pose, simulation space; of one sign along a path, so that numbers between two can be interpolated.
        /// </summary>
        public Quaternion Rotation;
    }
}
