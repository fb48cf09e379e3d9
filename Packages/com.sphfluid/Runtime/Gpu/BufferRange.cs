using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A part of a buffer, so that kernels need one buffer for what would be several. Kernels know the buffer by its own name and where the
    /// part begins by this one's: "Densities" in "Neighbours" begins at _DensitiesBegin of _Neighbours, or of _NeighboursOut to write.
    /// </summary>
    internal sealed class BufferRange
    {
        internal BufferRange(FluidBuffer buffer, string name, int begin)
        {
            Buffer = buffer;
            BeginId = Shader.PropertyToID("_" + name + "Begin");
            Begin = begin;
        }

        /// <summary>The whole.</summary>
        public FluidBuffer Buffer { get; }

        /// <summary>Property id of <see cref="Begin"/>.</summary>
        public int BeginId { get; }

        /// <summary>First element.</summary>
        public int Begin { get; }
    }
}
