using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid
{
    /// <summary>A particle of a wall: a row of walls.npy and of a body's file.</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct WallParticle
    {
        /// <summary>The columns as NumPy has them.</summary>
        public static readonly string[] Columns = { "x <f4", "y <f4", "z <f4", "u <f4", "v <f4", "w <f4" };

        /// <summary>Position [m]: simulation space, or of a body that moves from its pivot.</summary>
        public Vector3 Position;

        /// <summary>Velocity that the wall drags with, though it stays [m/s]: that of a belt.</summary>
        public Vector3 Velocity;
    }
}
