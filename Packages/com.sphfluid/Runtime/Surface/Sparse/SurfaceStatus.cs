namespace SphFluid
{
    /// <summary>What became of a sparse surface, as the GPU counted it; a few frames old.</summary>
    public readonly struct SurfaceStatus
    {
        internal SurfaceStatus(uint[] counters)
        {
            Blocks = (int)counters[SurfaceCounters.BlocksRequested];
            LateBlocks = (int)counters[SurfaceCounters.BlocksLate];
            Vertices = counters[SurfaceCounters.VerticesRequested];
            Triangles = counters[SurfaceCounters.IndicesRequested] / 3;
            OpenFaces = (int)counters[SurfaceCounters.OpenFaces];
            NonFiniteParticles = (int)counters[SurfaceCounters.NonFinite];
            IsComplete = counters[SurfaceCounters.Complete] != 0;
        }

        /// <summary>Blocks near the surface, all of which want room.</summary>
        public int Blocks { get; }

        /// <summary>Blocks among them that only their neighbours' surface led to; none is expected.</summary>
        public int LateBlocks { get; }

        /// <summary>Vertices that the surface has; 0 while its blocks do not fit.</summary>
        public long Vertices { get; }

        /// <summary>Triangles that the surface has; 0 while its blocks do not fit.</summary>
        public long Triangles { get; }

        /// <summary>Faces of blocks where the surface ends; none is expected.</summary>
        public int OpenFaces { get; }

        /// <summary>Particles that were passed over because their position is not a number.</summary>
        public int NonFiniteParticles { get; }

        /// <summary>Whether all of it fitted the buffers. If not, the last complete surface is still drawn.</summary>
        public bool IsComplete { get; }
    }
}
