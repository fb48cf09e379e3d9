using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// How much liquid went through a rectangle since it was asked for. The sums go on from answer to answer, so that nothing is lost
    /// between two; over the difference of <see cref="FluidQueries.AnsweredTime"/> they are a flow [m³/s].
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct FluidPatchResult
    {
        internal uint Forwards;
        internal uint Backwards;
        internal float ParticleVolume;
        internal uint Generation;
        internal Vector4 Unused;

        /// <summary>Volume that went through along the rectangle's forward axis [m³], by particles of a particle spacing cubed.</summary>
        public float Forward => Forwards * ParticleVolume;

        /// <summary>Volume that went through against it [m³].</summary>
        public float Backward => Backwards * ParticleVolume;

        /// <summary>Difference of both [m³].</summary>
        public float Volume => Particles * ParticleVolume;

        /// <summary>Particles that went through along the forward axis less those that went against it.</summary>
        public int Particles => unchecked((int)(Forwards - Backwards));
    }
}
