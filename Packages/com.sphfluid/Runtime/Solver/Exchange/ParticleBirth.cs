using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A particle that is to be born, as the GPU reads it: 32 bytes, <c>struct Birth</c> in Shaders/Solver/Cells/BirthParticles.compute.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct ParticleBirth
    {
        public const int Stride = 32;

        /// <summary>Position [m], simulation space.</summary>
        public Vector3 Position;

        /// <summary>Number, unique in the liquid: numbers count on, so older particles have lower ones.</summary>
        public uint Id;

        /// <summary>Velocity [m/s], simulation space.</summary>
        public Vector3 Velocity;

        /// <summary>Number of the source; sources do not overlap themselves. With <see cref="Pumps"/> of one that pumps.</summary>
        public uint Source;

        /// <summary>Bit of <see cref="Source"/>: a source that is free to put particles nearer to others.</summary>
        public const uint Pumps = 0x80000000u;
    }

    /// <summary>Births at the end of one step.</summary>
    internal readonly struct BirthBatch
    {
        /// <summary><see cref="ParticleBirth"/> each.</summary>
        public readonly GraphicsBuffer Births;

        /// <summary>Born, blocked and refused of each source.</summary>
        public readonly GraphicsBuffer Counts;

        public readonly int Count;

        /// <summary>Slots that may be filled: particles that the liquid may have, and those that leave in the same step.</summary>
        public readonly int Slots;

        /// <summary>Whether they come from several sources, which may be in each other's way.</summary>
        public readonly bool HasRivals;

        public BirthBatch(GraphicsBuffer births, GraphicsBuffer counts, int count, int slots, bool hasRivals)
        {
            Births = births;
            Counts = counts;
            Count = count;
            Slots = slots;
            HasRivals = hasRivals;
        }
    }
}
