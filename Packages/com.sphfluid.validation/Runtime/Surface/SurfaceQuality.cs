namespace SphFluid.Validation
{
    /// <summary>What a surface variant made of a state. Means over the frames unless a sum is said; not a number what the state does not tell.</summary>
    sealed class SurfaceQuality
    {
        /// <summary>Particles of a frame.</summary>
        public int Particles;

        /// <summary>Number of frames.</summary>
        public int Frames;

        /// <summary>Edge of a cell [dx].</summary>
        public double Cell;

        /// <summary>Triangles and vertices of a frame.</summary>
        public double Triangles, Vertices;

        /// <summary>Defects, summed over the frames: see <see cref="MeshEdges"/> and <see cref="TriangleShapes"/>.</summary>
        public int OpenEdges, NonManifoldEdges, FlippedEdges, ZeroArea;

        /// <summary>See <see cref="SurfaceVariant.TakeLateBlocks"/>, summed over the frames.</summary>
        public int LateBlocks;

        /// <summary>Euler characteristic and parts of a frame.</summary>
        public double Euler, Components;

        /// <summary>Volume of the mesh over that of the liquid.</summary>
        public double Volume = double.NaN;

        /// <summary>Deviation of the top from a plane, root mean square [dx]; its slope [degrees].</summary>
        public double Flatness = double.NaN, Slope = double.NaN;

        /// <summary>Height of the top over the liquid's level [dx], and how much it changes between frames, root mean square [dx].</summary>
        public double LevelError = double.NaN, Ripple = double.NaN;

        /// <summary>Share of the columns over the liquid that meet the mesh.</summary>
        public double Covered = double.NaN;

        /// <summary>Lone particles, and those of them that can be seen; of the frames together.</summary>
        public int Drops, DropsVisible;

        /// <summary>Radius of a ball as large as a visible drop, where there is nothing but drops [dx]: 0.62 is a spacing cubed.</summary>
        public double DropRadius = double.NaN;

        /// <summary>Widest gap at which two bodies are drawn as one [dx].</summary>
        public double MergeGap = double.NaN;

        /// <summary>Smallest angles of the triangles [degrees]: of all, of the worst hundredth, mean.</summary>
        public double LeastAngle = double.NaN, OnePercentAngle = double.NaN, MeanAngle = double.NaN;

        /// <summary>Error of the normals at vertices, and of the triangles [degrees].</summary>
        public double ShadingError = double.NaN, FaceError = double.NaN;

        /// <summary>See <see cref="ColumnStatistics.Flicker"/> [dx].</summary>
        public double Flicker = double.NaN;

        /// <summary>GPU time of the surface's passes in a frame [ms], the sort of the particles not counted.</summary>
        public double GpuMilliseconds = double.NaN;
    }
}
