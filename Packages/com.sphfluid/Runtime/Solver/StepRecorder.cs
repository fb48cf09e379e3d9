using System;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// The order of a liquid's steps: when its particles are loaded, when neighbours are found anew, and what comes before and after each
    /// motion. Counts how far it has come.
    /// </summary>
    internal sealed class StepRecorder
    {
        private readonly IFluidStepper stepper;
        private readonly FluidState state;
        private readonly CounterReadback counters;
        private readonly LoadedParticles particles;
        private FluidObstacles obstacles;
        private bool isLoaded, neighboursFresh, isPublished;

        /// <param name="stepper">What steps the liquid.</param>
        /// <param name="counters">What the GPU counts.</param>
        /// <param name="particles">The particles, uploaded.</param>
        public StepRecorder(IFluidStepper stepper, CounterReadback counters, LoadedParticles particles)
        {
            this.stepper = stepper;
            this.counters = counters;
            this.particles = particles;
            state = stepper.State;
        }

        /// <summary>What comes into the liquid and goes; null: nothing.</summary>
        public ParticleExchange Exchange { get; set; }

        /// <summary>Steps recorded since the start.</summary>
        public long StepCount { get; private set; }

        /// <summary>Time recorded since the start [s].</summary>
        public double SimulatedTime { get; private set; }

        /// <summary>Neighbour setups recorded since the start.</summary>
        public long SetupCount => stepper.SetupCount;

        /// <summary>Length of the last recorded step [s]; 0 before the first.</summary>
        public float PreviousStep { get; private set; }

        /// <summary>How far the liquid has come, besides its particles.</summary>
        public SolverProgress Progress => new SolverProgress
        {
            StepCount = StepCount,
            SimulatedTime = SimulatedTime,
            PreviousStep = PreviousStep,
            NextId = particles.NextId,
            Counters = counters.Counters,
        };

        /// <summary>Takes the triangles of the scene; null: none.</summary>
        public void SetObstacles(FluidObstacles obstacles)
        {
            this.obstacles = obstacles;
            if (obstacles == null) state.SetTriangles(null, null, 0);
        }

        /// <summary>Walls or physics have changed: neighbours are found anew.</summary>
        public void Forget() => neighboursFresh = false;

        /// <summary>Puts other particles in the place of the present ones, whose counts have been read.</summary>
        public void Replace(FluidParticle[] live)
        {
            particles.Replace(live);
            isLoaded = neighboursFresh = false;
        }

        /// <summary>
        /// Shows other particles in the place of the present ones, with the walls where they are now. Velocities are of the same time as
        /// positions.
        /// </summary>
        /// <param name="shown">The particles.</param>
        /// <param name="count">Number of them.</param>
        /// <param name="time">Time of the liquid [s].</param>
        public void Show(NativeArray<FluidParticle> shown, int count, double time)
        {
            particles.Show(shown, count);
            state.WallsChange();
            state.EndBodySteps();
            isLoaded = neighboursFresh = false;
            StepCount++;
            (SimulatedTime, PreviousStep) = (time, 0f);
        }

        /// <summary>Goes on from a save.</summary>
        public void Continue(FluidParticle[] live, in SolverProgress progress)
        {
            counters.Continue(progress.Counters);
            Replace(live);
            (StepCount, SimulatedTime, PreviousStep, particles.NextId) =
                (progress.StepCount, progress.SimulatedTime, progress.PreviousStep, progress.NextId);
        }

        /// <summary>Records steps, and a read-back of the counters.</summary>
        /// <param name="cmd">Command buffer to record into.</param>
        /// <param name="steps">Number of steps, one or more.</param>
        /// <param name="timeStep">Length of each [s].</param>
        /// <param name="flowSpeed">Speed at which bodies of the liquid move [m/s].</param>
        /// <param name="peakSpeed">Speed of the fastest particle [m/s].</param>
        /// <param name="longestStep">The longest step of late [s].</param>
        /// <param name="submit">Submits a part of them; null: they are not parted.</param>
        public void RecordSteps(
            CommandBuffer cmd, int steps, float timeStep, float flowSpeed, float peakSpeed, float longestStep, Action submit = null)
        {
            counters.RecordReset(cmd);
            particles.Bound(Exchange);
            if (state.WallsChange()) neighboursFresh = false; // what drawing was given has the walls at rest
            var blocks = new StepBlocks(steps, stepper.StepsPerSetup(steps, timeStep, flowSpeed));
            stepper.PlanSteps(blocks.LongestBlock, timeStep, peakSpeed, Mathf.Max(timeStep, longestStep));
            state.WallForces?.Begin(state, steps, obstacles?.Found ?? Array.Empty<FluidObstacle>());
            long work = 0;
            for (int i = 0; i < steps; i++)
            {
                state.BeginBodyStep(i, steps, timeStep);
                RecordSetup(cmd);
                RecordStep(cmd, timeStep, !blocks.IsLast(i));
                work += state.ParticleCount;
                if (submit == null || work < FluidSolver.WorkPerSubmission || i + 1 == steps) continue;
                submit();
                work = 0;
            }

            state.EndBodySteps();
            counters.RecordRequest(cmd);
            state.WallForces?.End(cmd);
            Exchange?.Counts.RecordRequest(cmd);
            state.Retired.EndFrame();
        }

        /// <summary>
        /// Records what brings neighbours, densities and what readers see up to the present positions; the next step uses it.
        /// </summary>
        public void RecordNeighbourSetup(CommandBuffer cmd)
        {
            RecordSetup(cmd);
            if (isPublished) return;
            stepper.RecordPublish(cmd);
            isPublished = true;
        }

        // A step that keeps the order leaves births and drains to the last of its block.
        private void RecordStep(CommandBuffer cmd, float timeStep, bool keeps)
        {
            if (!keeps) Exchange?.RecordLeaving(cmd, SimulatedTime + timeStep, timeStep);
            var step = new FluidStep(timeStep, StepCount == 0 ? timeStep : PreviousStep, StepCount == 0, keeps);
            state.WallForces?.RecordStep(cmd, state, step, SimulatedTime + timeStep);
            stepper.RecordMotion(cmd, step);
            if (!keeps) Exchange?.RecordBirths(cmd);
            PreviousStep = timeStep;
            neighboursFresh = false;
            StepCount++;
            SimulatedTime += timeStep;
        }

        private void RecordSetup(CommandBuffer cmd)
        {
            if (obstacles != null)
            {
                state.SetTriangles(obstacles.Scene.TriangleBuffer, obstacles.Scene.ColliderBuffer, obstacles.Scene.Colliders.Count);
            }
            if (!isLoaded) stepper.RecordLoad(cmd);
            isLoaded = true;
            if (neighboursFresh) return;
            stepper.RecordNeighbourSetup(cmd);
            neighboursFresh = true;
            isPublished = false;
        }
    }
}
