using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Steps a liquid by the Standard method in four dependent dispatches: ScanCells, Scatter, StandardDensity, MoveParticles;
    /// the stable order makes Scatter two. Triangles add three: GatherWalls before the density, FindContacts and ResolveContacts after
    /// the motion, and bodies that the liquid moves MoveBodies before the first and after the motion. A step that keeps the order and lists
    /// of an earlier one has two, ListedDensity and MoveParticles, and the same three of triangles. An implicit viscosity has several in
    /// the place of MoveParticles: KickParticles, DiffuseVelocities and DriftParticles. A force with passes of its own
    /// (<see cref="StandardForces"/>) adds them before the motion.
    /// </summary>
    internal sealed class StandardStepper : CellStepper
    {
        private readonly StandardState state;
        private readonly StandardDensityPass density;
        private readonly MoveParticlesPass moveParticles;
        private readonly Dictionary<ParticleForce, ForcePasses> forces = new Dictionary<ParticleForce, ForcePasses>();
        private KickParticlesPass kickParticles;
        private DiffuseVelocitiesPass diffuseVelocities;
        private DriftParticlesPass driftParticles;
        private NeighbourList listed; // filled since the last sort
        private bool isLoaded;
        private float listTime;
        private float lastStep;

        public StandardStepper(in FluidSolverSettings settings, FluidShaderSet shaders, int particleCount) : base(shaders)
        {
            density = new StandardDensityPass(shaders);
            moveParticles = new MoveParticlesPass(shaders);
            state = new StandardState(settings, particleCount) { GatherAsleep = cmd => GatherWalls.RecordAsleep(cmd, state) };
        }

        /// <summary>What the passes work on.</summary>
        public StandardState State => state;

        /// <inheritdoc/>
        protected override CellState Cells => state;

        /// <inheritdoc/>
        public override void RecordLoad(CommandBuffer cmd)
        {
            state.RequireCarried(StandardForces.All);
            base.RecordLoad(cmd);
            isLoaded = false;
            lastStep = 0f;
        }

        /// <inheritdoc/>
        public override int StepsPerSetup(int steps, float timeStep, float speed) =>
            StandardRules.StepsPerSort(
                state.Own, ListReuse.StepsAfter(state, steps, timeStep, speed, StandardRules.ListClosing(state.Own)));

        /// <inheritdoc/>
        public override void PlanSteps(int steps, float timeStep, float speed, float longest) => listTime = (steps - 1) * timeStep;

        /// <inheritdoc/>
        public override void RecordNeighbourSetup(CommandBuffer cmd)
        {
            state.RequireList();
            state.RequireCarried(StandardForces.All);
            bool isAnew = Order == ParticleOrder.Sorted; // constants or walls are others, and the density before is gone
            if (!isAnew && Order != ParticleOrder.Left) listed = null;
            state.Impact = lastStep > 0f && !isAnew ? StandardRules.Impact(state.Settings, lastStep) : Vector2.zero;
            if (Order == ParticleOrder.Counted)
            {
                state.ListTime = isLoaded ? listTime : 0f; // which of the particles just loaded are at a surface is not known yet
                Sort(cmd);
                state.ExchangeCarried();
                isLoaded = true;
            }
            else if (Order == ParticleOrder.Left) // what the last step left is what this one begins with
            {
                FluidBuffer.Exchange(state.Buffers.Velocities, state.Buffers.NewVelocities);
                Order = ParticleOrder.Kept;
            }

            if (isAnew && state.HasSleepers && state.Sleep.WakesNow)
            {
                Sleeping.RecordWake(cmd, state);
                listed = null; // what slept has no list
            }
            bool isKept = state.KeepsOrder = Order == ParticleOrder.Kept;
            if (state.HasBodies)
            {
                state.RequireWalls();
                if (state.HasFloatingBodies) MoveBodies.RecordBegin(cmd, state);
                GatherWalls.Record(cmd, state, isKept ? state.Buffers.NewPositions : state.Buffers.Positions,
                    isKept && !state.Bodies.IsUnderWay);
            }

            bool isListed = listed == state.List;
            if (isListed) density.RecordListed(cmd, state, isKept ? state.Buffers.NewPositions : state.Buffers.Positions);
            else
            {
                if (state.HasSleepers) Sleeping.RecordRest(cmd, state);
                density.Record(cmd, state);
            }
            if (state.HasSleepers) Sleeping.RecordSoftness(cmd, state, !isListed);
            listed = state.List;
        }

        /// <inheritdoc/>
        public override void RecordMotion(CommandBuffer cmd, in FluidStep step)
        {
            foreach (ParticleForce force in StandardForces.All)
                if (force.Acts(state.Own)) RecordForce(cmd, force, step);
            if (state.Own.ImplicitViscosity) RecordViscousMotion(cmd, step);
            else moveParticles.Record(cmd, state, step);
            if (state.HasBodies)
            {
                if (state.HasFloatingBodies) MoveBodies.Record(cmd, state, step);
                ProveMotion(cmd, step, state.Buffers.PositionTerms);
            }

            lastStep = step.Length;
            if (state.Sleep != null) state.Sleep.SinceSort += step.Length;
            if (state.HasSleepers) Sleeping.RecordCount(cmd, state, step);
            Order = step.KeepsOrder ? ParticleOrder.Left : ParticleOrder.Counted;
        }

        private void RecordForce(CommandBuffer cmd, ParticleForce force, in FluidStep step)
        {
            state.RequireForce(force);
            if (!forces.TryGetValue(force, out ForcePasses passes)) forces.Add(force, passes = force.MakePasses(Shaders));
            passes.Record(cmd, state, step);
        }

        private void RecordViscousMotion(CommandBuffer cmd, in FluidStep step)
        {
            state.RequireViscous();
            kickParticles ??= new KickParticlesPass(Shaders);
            diffuseVelocities ??= new DiffuseVelocitiesPass(Shaders);
            driftParticles ??= new DriftParticlesPass(Shaders);
            kickParticles.Record(cmd, state, step);
            diffuseVelocities.Record(cmd, state, step);
            driftParticles.Record(cmd, state, step);
        }
    }
}
