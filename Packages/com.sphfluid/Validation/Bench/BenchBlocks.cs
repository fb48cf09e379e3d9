using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>The profiler markers that are measured: one a block of the thesis, and one a drawing.</summary>
    static class BenchBlocks
    {
        public const string DrawParticles = "DrawParticles";
        public const string DrawSurface = "DrawSurface";

        /// <summary>A whole frame of the benchmark; the blocks lie inside.</summary>
        public const string Frame = "BenchFrame";

        /// <summary>In the order of a frame.</summary>
        public static readonly IReadOnlyList<string> Names = new[]
        {
            "CalculateParticleCellValue", "BitonicSort", "ResetGridIndices", "SetGridIndices", "SortParticles",
            "CalculateDensity", "CalculateForce", "CalculateAcceleration", "CalculateNewPosition",
            "ResetMCGrid", "SetMCGridDensityFactors", DrawParticles, DrawSurface,
        };
    }
}
