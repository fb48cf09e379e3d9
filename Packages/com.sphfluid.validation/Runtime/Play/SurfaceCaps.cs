using System;

namespace SphFluid.Validation
{
    /// <summary>What the sparse surface of a simulation could not do in a play, from what each frame knew of it.</summary>
    internal sealed class SurfaceCaps
    {
        /// <summary>
        /// Frames that still drew an older surface: the new one did not fit its buffers, which grow, or its triangle budget.
        /// </summary>
        public int StaleFrames { get; private set; }

        /// <summary>Most faces of blocks at which the surface ended in a frame.</summary>
        public int OpenFaces { get; private set; }

        /// <summary>Most particles that a frame passed over because their position is not a number.</summary>
        public int SkippedParticles { get; private set; }

        /// <summary>Takes in a frame.</summary>
        /// <param name="status">The surface as it was read back last; nothing before the first.</param>
        public void Observe(in SurfaceStatus status)
        {
            if (!status.IsComplete && status.Blocks > 0) StaleFrames++;
            OpenFaces = Math.Max(OpenFaces, status.OpenFaces);
            SkippedParticles = Math.Max(SkippedParticles, status.NonFiniteParticles);
        }
    }
}
