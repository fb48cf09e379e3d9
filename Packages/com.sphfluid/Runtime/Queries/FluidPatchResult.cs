using System.Runtime.InteropServices;

namespace SphFluid
{
    /// <summary>
    /// How much liquid went through a rectangle since it was asked for. The sums go on from answer to answer, so that nothing is lost between two; over the
    /// difference of <see cref="FluidQueries.AnsweredTime"/> they are a flow [m³/s].
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct FluidPatchResult
    {
        /// <summary>Volume that went through along the rectangle's forward axis [m³], by particles of a particle spacing cubed.</summary>
        public float Forward;

        /// <summary>Volume that went through against it [m³].</summary>
        public float Backward;

        internal uint Forwards;
        internal uint Backwards;
        internal uint Generation;
        internal uint Unused0;
        internal uint Unused1;
        internal uint Unused2;

        /// <summary>Difference of both [m³].</summary>
        public float Volume => Particles * (Forwards > 0 ? Forward / Forwards : Backwards > 0 ? Backward / Backwards : 0f);

        /// <summary>Particles that went through along the forward axis less those that went against it.</summary>
        public int Particles => unchecked((int)(Forwards - Backwards));
    }
}
