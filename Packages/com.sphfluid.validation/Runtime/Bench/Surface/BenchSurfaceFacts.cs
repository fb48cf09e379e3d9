namespace SphFluid.Validation
{
    /// <summary>What a measured surface consists of.</summary>
    public struct BenchSurfaceFacts
    {
        /// <summary>Cells along the domain's edge.</summary>
        public int Cells { get; set; }

        /// <summary>Edge of a cell [m].</summary>
        public double CellSize { get; set; }

        /// <summary>Number of triangles; null where the GPU counts none.</summary>
        public long? Triangles { get; set; }

        /// <summary>Number of vertices that the drawing reads or makes; null where the GPU counts none.</summary>
        public long? Vertices { get; set; }

        /// <summary>Blocks that were sampled; null for a dense grid.</summary>
        public long? ActiveBlocks { get; set; }

        /// <summary>Blocks that the domain is cut into; null for a dense grid.</summary>
        public long? PotentialBlocks { get; set; }

        /// <summary>GPU memory of field and mesh [bytes].</summary>
        public long GpuBytes { get; set; }

        /// <summary>Of a dense grid over the measured liquid's domain.</summary>
        /// <param name="cells">Cells a side.</param>
        /// <param name="bytes">GPU memory [bytes].</param>
        /// <param name="corners">Corners of triangles, three each and none shared; null where the GPU counts none.</param>
        internal static BenchSurfaceFacts Dense(int cells, long bytes, long? corners = null) => new BenchSurfaceFacts
        {
            Cells = cells,
            CellSize = BenchLiquid.Edge / cells,
            Triangles = corners / 3,
            Vertices = corners,
            GpuBytes = bytes,
        };
    }
}
