using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>The parts that are measured.</summary>
    internal static class FrameBlocks
    {
        public const string DrawParticles = "DrawParticles";
        public const string DrawSurface = "DrawSurface";
        public const string DrawWhitewater = "DrawWhitewater";

        public const string DrawThickness = "DrawThickness";
        public const string DrawSpray = "DrawSpray";

        /// <summary>A whole frame of the benchmark; the parts lie inside.</summary>
        public const string Frame = "BenchFrame";

        /// <summary>The first pass of every method's neighbour setup.</summary>
        public static readonly IReadOnlyList<string> Setup = new[] { "CalculateParticleCellValue", "ScanCells", "RankCells" };

        /// <summary>One a block of the thesis, and one a drawing, in the order of a frame.</summary>
        public static readonly IReadOnlyList<BenchBlock> Thesis = new[]
        {
            "CalculateParticleCellValue", "BitonicSort", "ResetGridIndices", "SetGridIndices", "SortParticles",
            "CalculateDensity", "CalculateForce", "CalculateAcceleration", "CalculateNewPosition",
            "ResetMCGrid", "SetMCGridDensityFactors", DrawParticles, DrawSurface,
        }.Select(name => new BenchBlock(name)).ToArray();

        /// <summary>What a surface consists of; each kind has some of them.</summary>
        public static readonly IReadOnlyList<BenchBlock> Surface = new[]
        {
            new BenchBlock("prepare", "ClearSurfaceBlocks", "PrepareSurfaceParticles"),
            new BenchBlock("list", "ListSurfaceBlocks"),
            new BenchBlock("field", "ResetMCGrid", "SetMCGridDensityFactors", "SampleBlocks"),
            new BenchBlock("count", "CountBlocks", "SurfaceDrawArguments"),
            new BenchBlock("emit", "EmitSurfaceVertices", "EmitBlocks"),
            new BenchBlock("draw", DrawSurface),
            new BenchBlock("thickness", DrawThickness),
            new BenchBlock("spray", "ListSpray", DrawSpray),
            new BenchBlock("foam", "WhitewaterMotion", "WhitewaterPotentials", "WhitewaterList"),
            new BenchBlock("drawfoam", DrawWhitewater),
        };

        /// <summary>What a step of every method consists of.</summary>
        public static readonly IReadOnlyList<BenchBlock> Step = new[]
        {
            new BenchBlock("sort", "CalculateParticleCellValue", "BitonicSort", "FusedBitonicSort", "ResetGridIndices", "SetGridIndices",
                "SortParticles",
                "ScanCells", "RankCells", "ScatterParticles"),
            new BenchBlock("density", "CalculateDensity", "StandardDensity", "ConstrainDensity"),
            new BenchBlock("motion", "CalculateForce", "CalculateAcceleration", "CalculateNewPosition", "MoveParticles",
                "PredictParticles", "MoveByConstraints", "FinishParticles"),
            new BenchBlock("colliders", "GatherWalls", "FindContacts", "ResolveContacts"),
        };
    }
}
