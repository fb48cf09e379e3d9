using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>The thesis's method, corrected or as printed.</summary>
    internal sealed class ThesisMethod : FluidMethod
    {
        private static readonly ShaderGroup Group = new ShaderGroup("the thesis method", "Thesis/Shaders/Solver",
            groupThreads: 1024, buffers: 7, writableBuffers: 3, groupMemory: 16384, vertexBuffers: 0,
            "CalculateParticleCellValue", "BitonicSort", "FusedBitonicSort", "ResetGridIndices", "SetGridIndices", "SortParticles",
            "CalculateDensity",
            "CalculateForce", "CalculateAcceleration", "CalculateNewPosition");

        private static readonly string[] Fields = { "timeStepFraction", "wallDistanceRatio", "wallStiffnessRatio", "wallDampingRatio",
            "thesisSwitches" };

        public ThesisMethod(FluidMethodKind kind)
        {
            Kind = kind;
        }

        public override FluidMethodKind Kind { get; }

        public override FluidMethodFeatures Features => FluidMethodFeatures.PenaltyWalls | FluidMethodFeatures.TwoKernels;

        public override ShaderGroup Shaders => Group;

        public override ShaderGroup OwnSurface => GeometrySurface.Group;

        public override IReadOnlyList<string> ProfileFields => Fields;

        public override long MaxCells => int.MaxValue;

        private bool IsPrinted => Kind == FluidMethodKind.ThesisPrinted;

        public override FluidSolverSettings Derive(in FluidRuleInput input) => ThesisRules.Derive(input);

        public override double PassesAStep => 3.0;

        public override TimeStepAdvice Advise(in FluidSolverSettings settings, double maxSpeed) => ThesisRules.Advise(settings, maxSpeed);

        public override bool SearchesOctants(in FluidRuleInput input) => IsPrinted || input.Switches.OctantSearch;

        public override bool OmitsOwnDensity(in FluidSolverSettings settings) => !settings.Own<ThesisSettings>().SelfDensity;

        public override FluidSolverSettings Prepare(in FluidSolverSettings settings)
        {
            if (!IsPrinted) return settings;
            ThesisSwitches printed = ThesisSwitches.Printed;
            printed.OctantSearch = settings.OctantSearch; // both searches find the same neighbours
            return settings.With(printed);
        }

        public override IFluidStepper Start(in FluidSolverSettings settings, FluidShaderSet shaders, int particleCount) =>
            new ThesisStepper(settings, shaders, particleCount);

        public override long PlannedBytes(in FluidSolverSettings settings, int particleCount, bool hasBodies, SleepRule? sleep = null)
        {
            using (var state = new ThesisState(settings, particleCount, true)) return state.Bytes;
        }
    }
}
