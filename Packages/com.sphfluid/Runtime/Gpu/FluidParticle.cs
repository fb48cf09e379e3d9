using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A particle as it lies in the GPU buffer: 48 bytes, mirrored by <c>struct Particle</c> in Shaders/Gpu/FluidTypes.hlsl.
    /// Simulation space: metres from the centre of the domain box, along its axes.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct FluidParticle
    {
        /// <summary>Size of a particle in bytes.</summary>
        public const int Stride = 48;

        /// <summary>Position [m].</summary>
        public Vector3 Position;

        /// <summary>Number given at the start or at birth; sorting moves particles, not their numbers.</summary>
        public uint Id;

        /// <summary>Velocity half a step after the last force [m/s]; the initial velocity before the first step.</summary>
        public Vector3 VelT0;

        /// <summary>
        /// 1 where there is no particle: one left the liquid, or none is born yet; all else is 0 then. 0 of a live particle.
        /// </summary>
        public float Removed;

        /// <summary>Velocity at the time of the last force [m/s], one step before <see cref="Position"/>.</summary>
        public Vector3 VelT1;

        /// <summary>What the gradient correction adds to the density [kg/m³]; 0 where it is not known yet, and without it.</summary>
        public float DensityOffset;

        /// <summary>A particle at the start of a simulation.</summary>
        /// <param name="position">Position [m], simulation space.</param>
        /// <param name="velocity">Initial velocity [m/s], simulation space.</param>
        /// <param name="id">Number of the particle, unique in its simulation.</param>
        public FluidParticle(Vector3 position, Vector3 velocity, uint id)
        {
            Position = position;
            Id = id;
            VelT0 = velocity;
            Removed = 0f;
            VelT1 = velocity;
            DensityOffset = 0f;
        }

        /// <summary>Whether there is no particle; drawing and measurements pass it over.</summary>
        public readonly bool IsRemoved => Removed != 0f;
    }
}
