namespace SphFluid
{
    /// <summary>Slots of the sparse surface's counters on the GPU: Shaders/Surface/Sparse/SurfaceCounters.hlsl.</summary>
    static class SurfaceCounters
    {
        public const int Slots = 16;

        /// <summary>Blocks that want a slot, those of the late round included.</summary>
        public const int BlocksRequested = 0;

        /// <summary>Blocks of the first round; 0 where not all fit.</summary>
        public const int BlocksListed = 1;

        /// <summary>Blocks of the late round.</summary>
        public const int BlocksLate = 2;

        /// <summary>First slot of the present round.</summary>
        public const int RoundFirst = 3;

        /// <summary>Slots of the present round.</summary>
        public const int RoundCount = 4;

        /// <summary>Vertices of all listed blocks.</summary>
        public const int VerticesRequested = 5;

        /// <summary>Indices of all listed blocks.</summary>
        public const int IndicesRequested = 6;

        /// <summary>Faces of blocks that the surface crosses towards a block without a slot, after the late round.</summary>
        public const int OpenFaces = 7;

        /// <summary>Particles passed over: their position is not a number.</summary>
        public const int NonFinite = 8;

        /// <summary>1 where the surface fitted the buffers and was emitted.</summary>
        public const int Complete = 9;
    }
}
