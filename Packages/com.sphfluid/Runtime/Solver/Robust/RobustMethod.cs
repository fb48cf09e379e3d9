using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>The Robust method: small-step XPBD of the density, whose steps no speed and no stiffness limits.</summary>
    internal sealed class RobustMethod : FluidMethod
    {
        private static readonly ShaderGroup Group = new ShaderGroup("the Robust method", "Shaders/Solver/Robust",
            groupThreads: 64, buffers: 13, writableBuffers: 6, groupMemory: 6144, vertexBuffers: 0,
            "PredictParticles", "ConstrainDensity", "MoveByConstraints", "FinishParticles").With(CellShaders.Group);

        private static readonly string[] Fields = { "substeps" };

        public override FluidMethodKind Kind => FluidMethodKind.Robust;

        public override FluidMethodFeatures Features => FluidMethodFeatures.OpenFaces | FluidMethodFeatures.BodyContact |
            FluidMethodFeatures.ColliderFriction | FluidMethodFeatures.ChangingCount | FluidMethodFeatures.ForceZones |
            FluidMethodFeatures.StepsByFrame;

        public override ShaderGroup Shaders => Group;

        public override IReadOnlyList<string> ProfileFields => Fields;

        public override long MaxCells => CellRows.MaxCells;

        public override bool StoresEmptyCells => false;

        public override FluidSolverSettings Derive(in FluidRuleInput input) => RobustRules.Derive(input);

        public override double PassesAStep => PassesFor(RobustRules.LeastIterations);

        public override double PassesOf(in FluidSolverSettings settings, double timeStep, double speed) =>
            PassesFor(RobustRules.IterationsFor(settings, timeStep, speed));

        public override bool MayBePicked => true;

        public override IReadOnlyList<MethodOffer> Offers(in MethodQuestion question) => new[] { RobustOffers.For(this, question) };

        public override TimeStepAdvice Advise(in FluidSolverSettings settings, double maxSpeed) => RobustRules.Advise(settings, maxSpeed);

        public override double CellCount(in FluidSolverSettings settings) => FluidGrid.CountFor(settings, CellRows.Border);

        public override double CoarsestFactor(in FluidRuleInput input, double asked) =>
            input.Substeps / (double)RobustRules.FewestSubsteps(input, asked);

        public override FluidRuleInput Coarsen(FluidRuleInput rules, double factor)
        {
            rules.Substeps = RobustRules.CoarserSubsteps(rules.Substeps, factor);
            return rules;
        }

        public override string CoarsestReason(in FluidRuleInput input, double asked, double reached)
        {
            int fewest = RobustRules.CoarserSubsteps(input.Substeps, reached);
            return fewest == RobustRules.CoarserSubsteps(input.Substeps, asked) ? null
                : $"; of its Substeps {fewest} are the fewest that keep the liquid's shape and take less work.";
        }

        public override string CoarsestCure => "Lower Step Factor, or raise Substeps of the profile.";

        public override IStepClock MakeClock(in FluidSolverSettings settings, int maxSteps)
        {
            int substeps = settings.Own<RobustSettings>().Substeps;
            return new FrameClock(substeps, RobustRules.LongestFrame / substeps, maxSteps, settings.TimeStep);
        }

        public override double EffectiveSoundSpeed(in FluidSolverSettings settings, double timeStep, double speed) =>
            RobustRules.EffectiveSoundSpeed(settings, timeStep, RobustRules.IterationsFor(settings, timeStep, speed));

        public override double ActingViscosity(in FluidSolverSettings settings, double timeStep) =>
            RobustRules.ActingViscosity(settings, timeStep, RobustRules.IterationsFor(settings, timeStep, 0.0)) / settings.RestDensity;

        public override IReadOnlyList<(string Label, string Value)> Remarks(in FluidSolverSettings settings, double timeStep, double speed)
        {
            RobustSettings own = settings.Own<RobustSettings>();
            int iterations = RobustRules.IterationsFor(settings, timeStep, speed);
            double sound = RobustRules.EffectiveSoundSpeed(settings, timeStep, iterations),
                compression = own.DepthSpeed * (double)own.DepthSpeed / (sound * sound);
            double viscosity = RobustRules.ActingViscosity(settings, timeStep, iterations);
            var remarks = new List<(string, string)>
            {
                ("Iterations of a step", FormattableString.Invariant($"{iterations}")),
                ("Effective speed of sound", FormattableString.Invariant($"{sound:G3} m/s")),
                ("Compression at the bottom",
                    FormattableString.Invariant($"{100.0 * compression:G2} %, {50.0 * compression:G2} % in the mean")),
            };
            if (viscosity < settings.Viscosity)
            {
                remarks
                    .Add(
                        ("Viscosity that acts",
                            FormattableString.Invariant($"{viscosity / settings.RestDensity:G2} m²/s: more would need shorter steps")));
            }
            return remarks;
        }

        public override FrameWork WorkOf(in FluidSolverSettings settings, double frameTime, double speed, double stepFraction)
        {
            int steps = FrameClock.StepsOf(frameTime, settings.Own<RobustSettings>().Substeps,
                RobustRules.LongestFrame / settings.Own<RobustSettings>().Substeps);
            double step = frameTime / steps;
            double kept = settings.Own<RobustSettings>().NeighbourList
                ? ListReuse.StepsAfter(settings, step, speed, ListReuse.CarefulClosing) : 0.0;
            double sorts = Math.Ceiling(Math.Max(0.0, steps - kept) / (kept + 1.0));
            return new FrameWork(steps, 2.0 * RobustRules.IterationsFor(settings, step, speed), sorts + 1.0, 1.0);
        }

        // Two an iteration, and the search.
        private static double PassesFor(int iterations) => 2.0 * iterations + 1.0;

        public override IFluidStepper Start(in FluidSolverSettings settings, FluidShaderSet shaders, int particleCount) =>
            new RobustStepper(settings, shaders, particleCount);

        public override long PlannedBytes(in FluidSolverSettings settings, int particleCount, bool hasBodies, SleepRule? sleep = null)
        {
            using (var state = new RobustState(settings, particleCount, true))
            {
                state.RequireList();
                if (hasBodies) state.RequireWalls();
                return state.Bytes;
            }
        }
    }
}
