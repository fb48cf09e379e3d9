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

        /// <summary>
        /// Particles whose walls are gathered, behind twice their groups, x, y and z, and their number: for this time, and, empty, for the
        /// next.
        /// </summary>
        public readonly FluidBuffer Walled;

        public MeshWallBuffers(int particleCount, bool isPlanned = false) : base(isPlanned)
        {
            long count = particleCount;
            NearWalls = Add("NearWalls", count, WallStride);
            // With Direct3D 11 Unity gives a buffer of indirect arguments typed and raw views, never structured ones.
            Contacts = Add("Contacts", ArgumentWords + count * (ContactWords + GapWords), sizeof(uint), Arguments);
            Walled = Add("Walled", 2 * ArgumentWords + count, sizeof(uint), Arguments);
            Walled.SetData(new uint[] { 0, 1, 1, 0, 0, 1, 1, 0 });
            WallGap = Contacts.Range("WallGap", ArgumentWords + count * ContactWords);
        }

        /// <summary>Which of the two are those of this time: bytes before them.</summary>
        public uint WalledArguments { get; private set; }

        /// <summary>Whether those of particles that sleep have not been gathered since the sort.</summary>
        public bool LackSleepers { get; set; }

        /// <summary>For the next time.</summary>
        public void BeginGathering() => WalledArguments = ArgumentWords * sizeof(uint) - WalledArguments;
    }
}
