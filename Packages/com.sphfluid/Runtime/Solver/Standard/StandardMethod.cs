using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>The Standard method: weakly compressible SPH with one kernel, walls that carry density, and a counting sort.</summary>
    internal sealed class StandardMethod : FluidMethod
    {
        static readonly ShaderGroup Group = new ShaderGroup("the Standard method", "Shaders/Solver/Standard",
            groupThreads: 64, buffers: 16, writableBuffers: 6, groupMemory: 6144, vertexBuffers: 0,
            "StandardDensity", "MoveParticles", "KickParticles", "DiffuseVelocities", "DriftParticles", "SurfaceNormals", "SurfaceTension").With(CellShaders.Group);

        static readonly string[] Fields = { "soundSpeedMode", "timeStepFraction", "surfaceTension", "tensionAtAnySpacing", "contactAngle" };

        // A walk over the neighbours that adds little to each, over the mean of those of density and forces: 0.73 measured with 8,160 particles and 7 iterations on llvmpipe.
        const double IterationShare = 0.7;

        public override FluidMethodKind Kind => FluidMethodKind.Standard;

        public override FluidMethodFeatures Features => FluidMethodFeatures.OpenFaces | FluidMethodFeatures.BodyContact |
            FluidMethodFeatures.ColliderFriction | FluidMethodFeatures.RelaxedStart | FluidMethodFeatures.FollowingSoundSpeed |
            FluidMethodFeatures.KeptNeighbours | FluidMethodFeatures.ChangingCount |
            FluidMethodFeatures.ForceZones | FluidMethodFeatures.WallForces | FluidMethodFeatures.SurfaceTension | FluidMethodFeatures.ImplicitViscosity;

        public override ShaderGroup Shaders => Group;

        public override IReadOnlyList<string> ProfileFields => Fields;

        public override long MaxCells => CellRows.MaxCells;

        public override FluidSolverSettings Derive(in FluidRuleInput input) => StandardRules.Derive(input);

        public override double PassesAStep => 3.0;

        public override string CostVariant(in FluidSolverSettings settings) =>
            (settings.Own<StandardSettings>().ImplicitViscosity ? "+viscous" : "") + (settings.Own<StandardSettings>().SurfaceTension > 0f ? "+tension" : "");

        public override FluidMethodFeatures AskedBy(in FluidRuleInput input)
        {
            FluidRuleInput own = input;
            own.Method = Kind;
            StandardSettings settings = Derive(own).Own<StandardSettings>();
            return (settings.SurfaceTension > 0f ? FluidMethodFeatures.SurfaceTension : FluidMethodFeatures.None) |
                (settings.ImplicitViscosity ? FluidMethodFeatures.ImplicitViscosity : FluidMethodFeatures.None);
        }

        public override bool MayBePicked => true;

        public override IReadOnlyList<MethodOffer> Offers(in MethodQuestion question) => StandardOffers.For(question);

        public override TimeStepAdvice Advise(in FluidSolverSettings settings, double maxSpeed) => StandardRules.Advise(settings, maxSpeed);

        public override FrameWork WorkOf(in FluidSolverSettings settings, double frameTime, double speed, double stepFraction)
        {
            double step = Advise(settings, speed).Step(stepFraction);
            int steps = FrameWork.StepsOf(frameTime, step), perSort = ListReuse.Steps(settings, step, speed);
            StandardSettings own = settings.Own<StandardSettings>();
            double solution = own.ImplicitViscosity ? IterationShare * ImplicitViscosity.Iterations(settings, step) : 0.0;
            double walks = 2.0 + solution + (own.SurfaceTension > 0f ? 2.0 * IterationShare : 0.0);
            return new FrameWork(steps, walks, Math.Ceiling(steps / (double)perSort));
        }

        public override double CellCount(in FluidSolverSettings settings) => FluidGrid.CountFor(settings, CellRows.Border);

        public override IFluidStepper Start(in FluidSolverSettings settings, FluidShaderSet shaders, int particleCount) =>
            new StandardStepper(settings, shaders, particleCount);

        public override long PlannedBytes(in FluidSolverSettings settings, int particleCount, bool hasBodies)
        {
            using (var state = new StandardState(settings, particleCount, true))
            {
                state.RequireList();
                if (hasBodies) state.RequireWalls();
                if (state.Own.ImplicitViscosity) state.RequireViscous();
                if (state.Own.SurfaceTension > 0f) state.RequireTension();
                return state.Bytes;
            }
        }
    }
}
