using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Steps a liquid by the Robust method: PredictParticles, the sort at the predicted places (ScanCells and Scatter, in two dispatches
    /// for a stable order), n times ConstrainDensity and MoveByConstraints, then FinishParticles. Triangles add GatherWalls, and
    /// FindContacts and ResolveContacts twice: for the prediction, so that no particle meets liquid behind a wall, and for the step as a
    /// whole. Readers get an order of their own: a sort and a density at the end of a frame.
    /// </summary>
    internal sealed class RobustStepper : CellStepper
    {
        private readonly RobustState state;
        private readonly PredictParticlesPass predictParticles;
        private readonly ConstrainDensityPass constrainDensity;
        private readonly MoveByConstraintsPass moveByConstraints;
        private readonly FinishParticlesPass finishParticles;
        private int iterations = RobustRules.LeastIterations;
        private float longestStep;
        private bool hasPressures;

        public RobustStepper(in FluidSolverSettings settings, FluidShaderSet shaders, int particleCount) : base(shaders)
        {
            predictParticles = new PredictParticlesPass(shaders);
            constrainDensity = new ConstrainDensityPass(shaders);
            moveByConstraints = new MoveByConstraintsPass(shaders);
            finishParticles = new FinishParticlesPass(shaders);
            state = new RobustState(settings, particleCount);
        }

        /// <summary>What the passes work on.</summary>
        public RobustState State => state;

        /// <inheritdoc/>
        protected override CellState Cells => state;

        /// <inheritdoc/>
        protected override FluidBuffer Places => Order == ParticleOrder.Sorted ? state.Buffers.Positions : state.Buffers.NewPositions;

        /// <inheritdoc/>
        public override void RecordLoad(CommandBuffer cmd)
        {
            base.RecordLoad(cmd);
            hasPressures = false;
        }

        /// <summary>All: a step sorts for itself, and readers are sorted for behind the last.</summary>
        public override int StepsPerSetup(int steps, float timeStep, float speed) => steps;

        /// <inheritdoc/>
        public override void PlanSteps(int steps, float timeStep, float speed, float longest)
        {
            iterations = RobustRules.IterationsFor(state.Settings, timeStep, speed);
            longestStep = longest;
        }

        /// <inheritdoc/>
        public override void RecordNeighbourSetup(CommandBuffer cmd)
        {
            state.RequireList();
            if (Order == ParticleOrder.Counted) Sort(cmd);
            if (!state.HasBodies) return;
            state.RequireWalls();
            if (state.HasFloatingBodies) MoveBodies.RecordBegin(cmd, state);
            // else those of the last step are there
            if (Order == ParticleOrder.Sorted) GatherWalls.Record(cmd, state, state.Buffers.Positions);
        }

        /// <inheritdoc/>
        public override void RecordMotion(CommandBuffer cmd, in FluidStep step)
        {
            var sorting = new FluidStep(step.Length, step.Previous, step.IsFirst);
            predictParticles.Record(cmd, state, sorting, Order == ParticleOrder.Left);
            if (state.HasBodies) ProveMotion(cmd, sorting, state.Motion.NewStarts);
            Sort(cmd);
            if (state.HasBodies) GatherWalls.Record(cmd, state, state.Buffers.Positions, isAtEnd: true);
            double compliance = RobustRules.Compliance(state.Settings, step.Length, longestStep, iterations);
            for (int i = 0; i < iterations; i++)
            {
                if (i == 0) constrainDensity.Record(cmd, state, compliance);
                else constrainDensity.RecordListed(cmd, state, compliance);
                if (i + 1 < iterations) moveByConstraints.Record(cmd, state, step.Length, i == 0);
            }

            finishParticles.Record(cmd, state, step, iterations);
            if (state.HasBodies)
            {
                if (state.HasFloatingBodies) MoveBodies.Record(cmd, state, step);
                ProveMotion(cmd, step, state.Motion.Starts);
            }

            Order = step.KeepsOrder ? ParticleOrder.Left : ParticleOrder.Counted;
            hasPressures = true;
        }

        /// <inheritdoc/>
        public override void RecordPublish(CommandBuffer cmd)
        {
            constrainDensity.RecordMeasured(cmd, state, hasPressures);
            base.RecordPublish(cmd);
        }
    }
}
