namespace SphFluid
{
    /// <summary>What is needed only where there are triangles: walls near particles, and contacts.</summary>
    internal sealed class MeshWallBuffers : BufferSet
    {
        /// <summary>Bytes of PackedWall in Shaders/Solver/Cells/PackedWall.hlsl.</summary>
        public const int WallStride = 108;

        // Words of a particle in Shaders/Solver/Cells/Contacts.hlsl, and those before the first.
        private const int ContactWords = 4, ArgumentWords = 4, GapWords = 4;

        /// <summary>PackedWall each.</summary>
        public readonly FluidBuffer NearWalls;

        /// <summary>
        /// Groups that resolve the steps that are not free, x, y, z, and the number of those steps; then of each the particle and where it
        /// began.
        /// </summary>
        public readonly FluidBuffer Contacts;

        /// <summary>
        /// Where each particle gathered its walls, and how near to there surely no triangle at rest is [m], 0 where that is not known.
        /// </summary>
        public readonly BufferRange WallGap;

        public MeshWallBuffers(int particleCount, bool isPlanned = false) : base(isPlanned)
        {
            long count = particleCount;
            NearWalls = Add("NearWalls", count, WallStride);
            // With Direct3D 11 Unity gives a buffer of indirect arguments typed and raw views, never structured ones.
            Contacts = Add("Contacts", ArgumentWords + count * (ContactWords + GapWords), sizeof(uint), Arguments);
            WallGap = Contacts.Range("WallGap", ArgumentWords + count * ContactWords);
        }
    }
}
