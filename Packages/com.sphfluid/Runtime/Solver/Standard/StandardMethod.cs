using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>The Standard method: weakly compressible SPH with one kernel, walls that carry density, and a counting sort.</summary>
    internal sealed class StandardMethod : FluidMethod
    {
        static readonly ShaderGroup Group = new ShaderGroup("the Standard method", "Shaders/Solver/Standard",
            groupThreads: 64, buffers: 17, writableBuffers: 7, groupMemory: 6144, vertexBuffers: 0,
            "StandardDensity", "MoveParticles", "KickParticles", "DiffuseVelocities", "DriftParticles").With(CellShaders.Group);

        static readonly string[] Fields = { "soundSpeedMode", "timeStepFraction" };

        public override FluidMethodKind Kind => FluidMethodKind.Standard;

        public override FluidMethodFeatures Features => FluidMethodFeatures.OpenFaces | FluidMethodFeatures.BodyContact |
            FluidMethodFeatures.ColliderFriction | FluidMethodFeatures.RelaxedStart | FluidMethodFeatures.FollowingSoundSpeed |
            FluidMethodFeatures.KeptNeighbours | FluidMethodFeatures.ChangingCount |
            FluidMethodFeatures.ForceZones | FluidMethodFeatures.WallForces;

        public override ShaderGroup Shaders => Group;

        public override IReadOnlyList<string> ProfileFields => Fields;

        public override long MaxCells => CellRows.MaxCells;

        public override FluidSolverSettings Derive(in FluidRuleInput input) => StandardRules.Derive(input);

        public override TimeStepAdvice Advise(in FluidSolverSettings settings, double maxSpeed) => StandardRules.Advise(settings, maxSpeed);

        public override FrameWork WorkOf(in FluidSolverSettings settings, double frameTime, double speed, double stepFraction)
        {
            double step = Advise(settings, speed).Step(stepFraction);
            int steps = FrameWork.StepsOf(frameTime, step), perSort = ListReuse.Steps(settings, step, speed);
            return new FrameWork(steps, 2.0, Math.Ceiling(steps / (double)perSort));
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
                return state.Bytes;
            }
        }
    }
}
