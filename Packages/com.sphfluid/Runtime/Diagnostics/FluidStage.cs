using System.Collections.Generic;
using System.Linq;

namespace SphFluid
{
    /// <summary>A part of the work on the GPU that times are shown of: passes under one name.</summary>
    internal sealed class FluidStage
    {
        /// <summary>All stages; each pass of the package is in one of them.</summary>
        public static readonly IReadOnlyList<FluidStage> All = new[]
        {
            new FluidStage("neighbours", "ScanCells", "RankCells", "ScatterParticles", "SleepParticles",
                "CalculateParticleCellValue", "BitonicSort", "FusedBitonicSort", "ResetGridIndices", "SetGridIndices", "SortParticles"),
            new FluidStage("density", "StandardDensity", "ConstrainDensity", "CalculateDensity"),
            new FluidStage("forces",
                new[] { "MoveParticles", "KickParticles", "DiffuseVelocities", "DriftParticles", "PredictParticles", "MoveByConstraints",
                "FinishParticles", "CalculateForce", "CalculateAcceleration",
                "CalculateNewPosition" }.Concat(FluidMethods.All.SelectMany(m => m.ForcePasses)).ToArray()),
            new FluidStage("colliders", "GatherWalls", "FindContacts", "ResolveContacts", "MoveBodies"),
            new FluidStage("in and out", "LoadParticles", "BirthParticles", "DrainParticles", "GrowParticles", "PublishParticles",
                "DampVelocities"),
            new FluidStage("measuring", "MeasureSpeeds", "MeasureStatistics", "PlaceWallPatches").With(QueryKind.Shaders.Shaders),
            new FluidStage("surface", "ClearSurfaceBlocks", "PrepareSurfaceParticles", "ListSpray", "ListSurfaceBlocks", "SampleBlocks",
                "CountBlocks",
                "SurfaceDrawArguments", "EmitBlocks", "WriteSurfaceMesh",
                "ResetMCGrid", "SetMCGridDensityFactors", "CountSurfaceVertices", "EmitSurfaceVertices"),
            new FluidStage("whitewater", "WhitewaterPotentials", "WhitewaterMotion", "WhitewaterList"),
        };

        private FluidStage(string name, params string[] passes)
        {
            Name = name;
            Passes = passes;
        }

        /// <summary>What it is called.</summary>
        public string Name { get; }

        /// <summary>Names of the passes, which are those of their markers in the Profiler.</summary>
        public IReadOnlyList<string> Passes { get; }

        private FluidStage With(IEnumerable<string> passes) => new FluidStage(Name, Passes.Concat(passes).ToArray());
    }
}
