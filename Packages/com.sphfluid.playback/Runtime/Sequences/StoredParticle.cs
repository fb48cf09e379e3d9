using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid
{
    /// <summary>A particle as the files of a sequence have it: 28 bytes, little endian. Simulation space.</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct StoredParticle
    {
        /// <summary>Size of a particle in bytes.</summary>
        public const int Stride = 28;

        /// <summary>Position [m].</summary>
        public Vector3 Position;

        /// <summary>Velocity [m/s].</summary>
        public Vector3 Velocity;

        /// <summary>Number, the same in all frames.</summary>
        public uint Id;

        /// <summary>A particle of a liquid, at rest or half a step after its last force.</summary>
        /// <param name="particle">The particle.</param>
        public static StoredParticle Create(in FluidParticle particle) =>
            new StoredParticle { Position = particle.Position, Velocity = particle.VelT0, Id = particle.Id };
    }
}
