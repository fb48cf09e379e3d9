using System.Collections.Generic;
using Unity.Profiling;

namespace SphFluid
{
    /// <summary>The package's counters in the Profiler: what all liquids together did in a frame.</summary>
    internal static class FluidProfiler
    {
        /// <summary>Category of the counters.</summary>
        public const string Category = "SPH Fluid";

        /// <summary>Particles of the running liquids, as of the last read-back.</summary>
        public const string Particles = "Fluid Particles";

        /// <summary>Steps that were given to the GPU.</summary>
        public const string Steps = "Fluid Steps";

        /// <summary>Liquids that would have needed more steps than Max Substeps Per Frame.</summary>
        public const string CapHits = "Fluid Substep Cap Hits";

        /// <summary>Triangles of the surfaces, as of the last read-back.</summary>
        public const string Triangles = "Fluid Surface Triangles";

        /// <summary>Particles that are drawn as spray, as of the last read-back.</summary>
        public const string Spray = "Fluid Spray Particles";

        /// <summary>GPU memory of liquids and surfaces [bytes].</summary>
        public const string GpuMemory = "Fluid GPU Memory";

        /// <summary>All of them.</summary>
        public static readonly IReadOnlyList<string> Names = new[] { Particles, Steps, CapHits, Triangles, Spray, GpuMemory };

        private static readonly ProfilerCategory category = new ProfilerCategory(Category);
        private static readonly FrameCounter particles = new FrameCounter(category, Particles, ProfilerMarkerDataUnit.Count);
        private static readonly FrameCounter steps = new FrameCounter(category, Steps, ProfilerMarkerDataUnit.Count);
        private static readonly FrameCounter capHits = new FrameCounter(category, CapHits, ProfilerMarkerDataUnit.Count);
        private static readonly FrameCounter triangles = new FrameCounter(category, Triangles, ProfilerMarkerDataUnit.Count);
        private static readonly FrameCounter spray = new FrameCounter(category, Spray, ProfilerMarkerDataUnit.Count);
        private static readonly FrameCounter memory = new FrameCounter(category, GpuMemory, ProfilerMarkerDataUnit.Bytes);

        /// <summary>Adds a liquid's frame.</summary>
        public static void AddLiquid(long particleCount, long stepsTaken, long timesCapped, long bytes)
        {
            particles.Add(particleCount);
            steps.Add(stepsTaken);
            capHits.Add(timesCapped);
            memory.Add(bytes);
        }

        /// <summary>Adds a surface that is drawn in a frame.</summary>
        public static void AddSurface(long triangleCount, long sprayCount, long bytes)
        {
            triangles.Add(triangleCount);
            spray.Add(sprayCount);
            memory.Add(bytes);
        }
    }
}
