using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid
{
    /// <summary>The Standard method: weakly compressible SPH with one kernel, walls that carry density, and a counting sort.</summary>
    internal sealed class StandardMethod : FluidMethod
    {
        private static readonly ShaderGroup Group = new ShaderGroup("the Standard method", "Shaders/Solver/Standard",
            groupThreads: 64, buffers: 11, writableBuffers: 4, groupMemory: 6144, vertexBuffers: 0,
            new[] { "StandardDensity", "MoveParticles", "KickParticles", "DiffuseVelocities",
                "DriftParticles" }.Concat(StandardForces.Shaders).ToArray())
            .With(CellShaders.Group);

        private static readonly string[] Fields = new[] { "soundSpeedMode", "timeStepFraction" }.Concat(StandardForces.ProfileFields)
            .ToArray();

        // A walk over the neighbours that adds little to each, over the mean of those of density and forces: 0.73 measured with 8,160
        // particles and 7 iterations on llvmpipe.
        private const double IterationShare = 0.7;

        public override FluidMethodKind Kind => FluidMethodKind.Standard;

        public override FluidMethodFeatures Features => FluidMethodFeatures.OpenFaces | FluidMethodFeatures.BodyContact |
            FluidMethodFeatures.ColliderFriction | FluidMethodFeatures.RelaxedStart | FluidMethodFeatures.FollowingSoundSpeed |
            FluidMethodFeatures.KeptNeighbours | FluidMethodFeatures.ChangingCount |
            FluidMethodFeatures.ForceZones | FluidMethodFeatures.WallForces | FluidMethodFeatures.ImplicitViscosity |
            FluidMethodFeatures.SleepingParts | ForceFeatures;

        public override FluidMethodFeatures ForceFeatures => StandardForces.Features;

        public override IEnumerable<string> ForcePasses => StandardForces.Shaders;

        public override ShaderGroup Shaders => Group;

        public override IReadOnlyList<string> ProfileFields => Fields;

        public override long MaxCells => CellRows.MaxCells;

        public override bool StoresEmptyCells => false;

        public override FluidSolverSettings Derive(in FluidRuleInput input) => StandardRules.Derive(input);

        public override double CoarsestFactor(in FluidRuleInput input, double asked) => StandardRules.CoarsestFactor(input, asked);

        public override FluidRuleInput Coarsen(FluidRuleInput rules, double factor)
        {
            rules.SoundSpeedRatio = (float)(rules.SoundSpeedRatio / factor);
            rules.MaxCompression = (float)(rules.MaxCompression * factor * factor);
            return rules;
        }

        public override string CoarsestReason(in FluidRuleInput input, double asked, double reached) =>
            StandardRules.CoarsestReason(asked, reached);

        public override string CoarsestCure => "Lower Step Factor, or raise Sound Speed Ratio and lower Max Compression of the profile.";

        public override double PassesAStep => 3.0;

        public override string CostVariant(in FluidSolverSettings settings)
        {
            StandardSettings own = settings.Own<StandardSettings>();
            return (own.ImplicitViscosity ? "+viscous" : "") + string.Concat(StandardForces.Acting(own).Select(force => force.CostVariant));
        }

        public override FluidMethodFeatures AskedBy(in FluidRuleInput input)
        {
            FluidRuleInput own = input;
            own.Method = Kind;
            StandardSettings settings = Derive(own).Own<StandardSettings>();
            FluidMethodFeatures viscous = settings.ImplicitViscosity ? FluidMethodFeatures.ImplicitViscosity : FluidMethodFeatures.None;
            return StandardForces.Acting(settings).Aggregate(viscous, (asked, force) => asked | force.Feature);
        }

        public override string Describe(FluidMethodFeatures missing, in FluidRuleInput input)
        {
            foreach (ParticleForce force in StandardForces.All)
                if ((missing & force.Feature) != 0) return force.Describe(input);
            return (missing & FluidMethodFeatures.ImplicitViscosity) != 0
                ? FormattableString.Invariant($"implicit viscosity, which this liquid of {input.KinematicViscosity:G3} m²/s needs")
                : null;
        }

        protected override void CheckForces(in FluidSolverSettings settings)
        {
            StandardSettings own = settings.Own<StandardSettings>();
            foreach (ParticleForce force in StandardForces.All) force.Validate(own);
            foreach (string shortfall in StandardForces.Acting(own).SelectMany(force => force.Shortfalls))
            {
                throw new ArgumentException(shortfall);
            }
        }

        public override bool MayBePicked => true;

        public override IReadOnlyList<MethodOffer> Offers(in MethodQuestion question) => StandardOffers.For(question);

        public override TimeStepAdvice Advise(in FluidSolverSettings settings, double maxSpeed) => StandardRules.Advise(settings, maxSpeed);

        public override FrameWork WorkOf(in FluidSolverSettings settings, double frameTime, double speed, double stepFraction)
        {
            double step = Advise(settings, speed).Step(stepFraction);
            StandardSettings own = settings.Own<StandardSettings>();
            double after = own.NeighbourList ? ListReuse.StepsAfter(settings, step, speed, StandardRules.ListClosing(own)) : 0.0;
            int steps = FrameWork.StepsOf(frameTime, step), perSort = StandardRules.StepsPerSort(own, after);
            double solution = own.ImplicitViscosity ? IterationShare * ImplicitViscosity.Iterations(settings, step) : 0.0;
            double walks = 2.0 + solution + IterationShare * StandardForces.Acting(own).Sum(force => force.Walks);
            return new FrameWork(steps, walks, Math.Ceiling(steps / (double)perSort));
        }

        public override double CellCount(in FluidSolverSettings settings) => FluidGrid.CountFor(settings, CellRows.Border);

        public override IFluidStepper Start(in FluidSolverSettings settings, FluidShaderSet shaders, int particleCount) =>
            new StandardStepper(settings, shaders, particleCount);

        public override long PlannedBytes(in FluidSolverSettings settings, int particleCount, bool hasBodies, SleepRule? sleep = null)
        {
            using (var state = new StandardState(settings, particleCount, true))
            {
                state.RequireList();
                if (hasBodies) state.RequireWalls();
                if (state.Own.ImplicitViscosity) state.RequireViscous();
                foreach (ParticleForce force in StandardForces.Acting(state.Own)) state.RequireForce(force);
                state.SetSleep(sleep);
                return state.Bytes;
            }
        }
    }
}
