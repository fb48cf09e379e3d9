using System;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Steps a liquid by the Robust method: PredictParticles, the sort at the predicted places where the lists of neighbours no longer
    /// serve (ScanCells and Scatter, in two dispatches for a stable order), n times ConstrainDensity and MoveByConstraints, the last time
    /// FinishParticles. Triangles add GatherWalls, and FindContacts and ResolveContacts twice: for the prediction, so that no particle
    /// meets liquid behind a wall, and for the step as a whole. Readers get an order of their own: a sort and a density at the end of a
    /// frame, whose lists the next steps go on with.
    /// </summary>
    internal sealed class RobustStepper : CellStepper
    {
        private readonly RobustState state;
        private readonly PredictParticlesPass predictParticles;
        private readonly ConstrainDensityPass constrainDensity;
        private readonly MoveByConstraintsPass moveByConstraints;
        private readonly FinishParticlesPass finishParticles;
        private int iterations = RobustRules.LeastIterations;
        private NeighbourList listed; // filled since the last sort
        private int keepable;  // steps that may go on with lists after they were made
        private int kept;      // that have
        private int stepsLeft; // of those that were planned
        private float stepLength, longestStep;
        private bool isLoaded, hasPressures;

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
            isLoaded = hasPressures = false;
        }

        /// <summary>All: steps sort for themselves when their lists no longer serve, and readers are sorted for behind the last.</summary>
        public override int StepsPerSetup(int steps, float timeStep, float speed)
        {
            keepable = (int)Math.Min(steps, ListReuse.StepsAfter(state, steps, timeStep, speed, ListReuse.CarefulClosing));
            return steps;
        }

        /// <inheritdoc/>
        public override void PlanSteps(int steps, float timeStep, float speed, float longest)
        {
            iterations = RobustRules.IterationsFor(state.Settings, timeStep, speed);
            (stepsLeft, stepLength, longestStep) = (steps, timeStep, longest);
        }

        /// <inheritdoc/>
        public override void RecordNeighbourSetup(CommandBuffer cmd)
        {
            state.RequireList();
            if (Order == ParticleOrder.Sorted) listed = null; // constants or walls are others
            if (Order == ParticleOrder.Counted) SortToKeep(cmd, keepable);
            if (!state.HasBodies) return;
            state.RequireWalls();
            if (state.HasFloatingBodies) MoveBodies.RecordBegin(cmd, state);
            // else those of the last step are there
            if (Order == ParticleOrder.Sorted) GatherWalls.Record(cmd, state, state.Buffers.Positions);
        }

        /// <inheritdoc/>
        public override void RecordMotion(CommandBuffer cmd, in FluidStep step)
        {
            bool keeps = kept < keepable;
            if (keeps && listed != state.List) List(cmd);
            Predict(cmd, step, keeps);
            double compliance = RobustRules.Compliance(state.Settings, step.Length, longestStep, iterations);
            for (int i = 0; i < iterations; i++)
            {
                if (i > 0) constrainDensity.RecordListed(cmd, state, compliance, state.Buffers.NewPositions);
                else if (keeps) constrainDensity.RecordListed(cmd, state, compliance, state.Buffers.Positions);
                else constrainDensity.Record(cmd, state, compliance);
                if (i == 0 || i + 1 < iterations) moveByConstraints.Record(cmd, state, step.Length, iterations, i == 0);
            }

            finishParticles.Record(cmd, state, step, iterations == 1);
            if (state.HasBodies)
            {
                if (state.HasFloatingBodies) MoveBodies.Record(cmd, state, step);
                ProveMotion(cmd, step, state.Motion.Starts);
            }

            listed = state.List;
            kept = keeps ? kept + 1 : 0;
            stepsLeft--;
            Order = step.KeepsOrder ? ParticleOrder.Left : ParticleOrder.Counted;
            hasPressures = true;
        }

        // The prediction, in the order of a sort there or of the last one.
        private void Predict(CommandBuffer cmd, in FluidStep step, bool keeps)
        {
            var prediction = new FluidStep(step.Length, step.Previous, step.IsFirst, keeps);
            predictParticles.Record(cmd, state, prediction, Order == ParticleOrder.Left);
            if (state.HasBodies) ProveMotion(cmd, prediction, state.Motion.NewStarts);
            if (keeps) state.TakePrediction();
            else SortToKeep(cmd, Math.Min(keepable, stepsLeft - 1));
            if (state.HasBodies) GatherWalls.Record(cmd, state, state.Buffers.Positions, isAtEnd: true);
        }

        private void SortToKeep(CommandBuffer cmd, int steps)
        {
            state.ListTime = isLoaded ? steps * stepLength : 0f; // which of the particles just loaded are at a surface is not known yet
            Sort(cmd);
            isLoaded = true;
            listed = null;
        }

        private void List(CommandBuffer cmd)
        {
            constrainDensity.RecordMeasured(cmd, state, hasPressures);
            listed = state.List;
            kept = 0;
        }

        /// <inheritdoc/>
        public override void RecordPublish(CommandBuffer cmd)
        {
            List(cmd);
            base.RecordPublish(cmd);
        }
    }
}
