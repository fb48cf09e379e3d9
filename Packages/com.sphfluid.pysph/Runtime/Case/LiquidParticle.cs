using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid
{
    /// <summary>A particle of the liquid: a row of liquid.npy. Simulation space.</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct LiquidParticle
    {
        /// <summary>The columns as NumPy has them.</summary>
        public static readonly string[] Columns = { "x <f4", "y <f4", "z <f4", "u <f4", "v <f4", "w <f4", "id <u4" };

        /// <summary>Position [m].</summary>
        public Vector3 Position;

        /// <summary>Velocity [m/s].</summary>
        public Vector3 Velocity;

        /// <summary>Number of the particle.</summary>
        public uint Id;

        /// <summary>A particle of a liquid, at rest or half a step after its last force.</summary>
        /// <param name="particle">The particle.</param>
        public static LiquidParticle Of(in FluidParticle particle) =>
            new LiquidParticle { Position = particle.Position, Velocity = particle.VelT0, Id = particle.Id };
    }
}
