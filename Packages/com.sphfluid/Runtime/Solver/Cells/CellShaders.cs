namespace SphFluid
{
    /// <summary>The shaders of what methods with a counting sort share.</summary>
    internal static class CellShaders
    {
        /// <summary>Sort, walls of triangles and contact with them, bodies that the liquid moves, births and drains.</summary>
        public static readonly ShaderGroup Group = new ShaderGroup("the sort by cells", "Shaders/Solver/Cells",
            groupThreads: 256, buffers: 10, writableBuffers: 7, groupMemory: 11520, vertexBuffers: 0,
            "LoadParticles", "ScanCells", "RankCells", "ScatterParticles", "GatherWalls", "MoveBodies", "FindContacts", "ResolveContacts",
            "SleepParticles", "DampVelocities",
            "PublishParticles", "DrainParticles", "BirthParticles", "GrowParticles");
    }
}
